import { defineParts } from './defineParts.ts'
import { SlideLab } from './slideLab.ts'
import { ThemeSwitch } from './themeSwitch.ts'

defineParts()
customElements.define('slide-lab', SlideLab)
customElements.define('theme-switch', ThemeSwitch)
