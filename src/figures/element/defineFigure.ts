import { SlideFigure } from './slideFigure.ts'

customElements.define('slide-figure', SlideFigure)
