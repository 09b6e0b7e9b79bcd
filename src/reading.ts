/* What the page has besides its lab. */
import { SlideFigure } from './figures/element/slideFigure.ts'
import './tutorial/index.ts'
import { lightOnPaper } from './ui/paper.ts'
import './ui/themeSwitch.ts'

customElements.define('slide-figure', SlideFigure)
lightOnPaper()
