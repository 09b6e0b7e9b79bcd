/* The elements in React's JSX. In a file of your own: import type {} from 'any-frame-rate/react' */
import type { DetailedHTMLProps, HTMLAttributes } from 'react'
import type {
  SlideFigureElement,
  SlideFigureEvents,
  SlideFigureProperties,
  SlideLabElement,
  SlideLabEvents,
  SlideLabProperties,
} from 'any-frame-rate/elements'

/** React 19 takes `onchange` of an element for a listener to `change`. */
type Handlers<Events> = {
  [Name in keyof Events & string as `on${Name}`]?: (event: Events[Name]) => void
}
type Own<Properties, Events> = Properties & Handlers<Events> & { class?: string }
type Known<Element extends HTMLElement, Properties, Events> = Own<Properties, Events> &
  Omit<DetailedHTMLProps<HTMLAttributes<Element>, Element>, keyof Own<Properties, Events>>

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'slide-lab': Known<SlideLabElement, SlideLabProperties, SlideLabEvents>
      'slide-figure': Known<SlideFigureElement, SlideFigureProperties, SlideFigureEvents>
    }
  }
}
