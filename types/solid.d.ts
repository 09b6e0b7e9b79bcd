/* The elements in Solid's JSX. In a file of your own: import type {} from 'any-frame-rate/solid' */
import type { JSX } from 'solid-js'
import type {
  SlideFigureElement,
  SlideFigureEvents,
  SlideFigureProperties,
  SlideLabElement,
  SlideLabEvents,
  SlideLabProperties,
} from 'any-frame-rate/elements'

type Listeners<Events> = {
  [Name in keyof Events & string as `on:${Name}`]?: (event: Events[Name]) => void
}
type Prefixed<Properties> = {
  [Name in keyof Properties & string as `prop:${Name}`]?: Properties[Name]
}
type Own<Properties, Events> = Properties & Prefixed<Properties> & Listeners<Events>
type Known<Element extends HTMLElement, Properties, Events> = Own<Properties, Events> &
  Omit<JSX.HTMLAttributes<Element>, keyof Own<Properties, Events>>

declare module 'solid-js' {
  namespace JSX {
    interface IntrinsicElements {
      'slide-lab': Known<SlideLabElement, SlideLabProperties, SlideLabEvents>
      'slide-figure': Known<SlideFigureElement, SlideFigureProperties, SlideFigureEvents>
    }
  }
}
