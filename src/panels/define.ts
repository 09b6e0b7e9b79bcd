import { defineParts } from '../lab/defineParts.ts'
import { SlideLab } from '../lab/slideLab.ts'
import { ThemeSwitch } from '../ui/themeSwitch.ts'

defineParts()
customElements.define('slide-lab', SlideLab)
customElements.define('theme-switch', ThemeSwitch)
