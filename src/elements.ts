import { published, setSite } from './lab/site.ts'
import { SlideFigureElement } from './elements/figure.ts'
import { SlideLabElement } from './elements/lab.ts'
import { defineLab } from './panels/slideLab.ts'

/**
 * The two elements for other people's pages, in one module. Markup may come before or after it, and both may stand in
 * shadow roots. What each offers stands above its class, and in custom-elements.json.
 */
export { SlideFigureElement, SlideLabElement }
export { setSite }
export type {
  SlideFigureEvents,
  SlideFigureProperties,
  SlideLabEvents,
  SlideLabProperties,
} from './elements/properties.ts'

declare global {
  interface HTMLElementTagNameMap {
    'slide-lab': SlideLabElement
    'slide-figure': SlideFigureElement
  }
}

// A server has no page to define them in. A page that has it twice, from two places, keeps the first.
if (typeof document === 'object' && !customElements.get('slide-lab')) {
  setSite(published)
  defineLab(SlideLabElement)
  customElements.define('slide-figure', SlideFigureElement)
}
