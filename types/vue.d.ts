/* The elements in Vue's templates. In a file of your own: import type {} from 'any-frame-rate/vue' */
import type { HTMLAttributes, PublicProps } from 'vue'
import type {
  SlideFigureElement,
  SlideFigureEvents,
  SlideFigureProperties,
  SlideLabElement,
  SlideLabEvents,
  SlideLabProperties,
} from 'any-frame-rate/elements'

type Listeners<Events> = {
  [Name in keyof Events & string as `on${Capitalize<Name>}`]?: (event: Events[Name]) => void
}
type Own<Properties, Events> = Properties & Listeners<Events>
/** A constructor with the two members that the compiler of templates reads. */
type Component<Element, Properties, Events> = new () => Element & {
  /** @deprecated Only for the types of templates. */
  $props: Own<Properties, Events> &
    Omit<HTMLAttributes & PublicProps, keyof Own<Properties, Events>>
  /** @deprecated Only for the types of templates. */
  $emit: <Name extends keyof Events>(name: Name, event: Events[Name]) => void
}

declare module 'vue' {
  interface GlobalComponents {
    'slide-lab': Component<SlideLabElement, SlideLabProperties, SlideLabEvents>
    'slide-figure': Component<SlideFigureElement, SlideFigureProperties, SlideFigureEvents>
  }
}
