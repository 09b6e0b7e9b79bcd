/* Files of other people's projects, and as much of React's and Solid's types as they need. */

/** In each, a line after `@ts-expect-error` must be refused, and every other accepted. */
export const fixtures = {
  'page.ts': `
    import 'any-frame-rate/elements'
    export const time: number | undefined = document.querySelector('slide-lab')?.playback.time
    document.createElement('slide-figure').set({ step: 0.2 })
    // @ts-expect-error
    export const text: string | undefined = document.querySelector('slide-lab')?.playback.time`,
  'react.tsx': `
    import type {} from 'any-frame-rate/react'
    import { useRef } from 'react'
    import type { SlideLabElement } from 'any-frame-rate/elements'
    export const Page = () => {
      const lab = useRef<SlideLabElement>(null)
      return (
        <slide-lab ref={lab} compact fps="10 60" experiment={{ scene: 'ramp' }} className="wide"
          onchange={(event) => event.detail.experiments.length}>
          <slide-figure name="area-under-v" slot="caption" values={{ step: 0.2 }}
            ontimeupdate={({ detail }) => detail.time.toFixed(1)} />
        </slide-lab>
      )
    }
    // @ts-expect-error
    export const scene = <slide-lab scene="ramps" />
    // @ts-expect-error
    export const unknown = <slide-lab colour="red" />
    // @ts-expect-error
    export const event = <slide-lab ontimeupdate={({ detail }) => detail.time.length} />
    // @ts-expect-error
    export const theme = <slide-figure theme="blue" />`,
  'solid.tsx': `
    import type {} from 'any-frame-rate/solid'
    let lab: HTMLElementTagNameMap['slide-lab'] | undefined
    export const page = (
      <slide-lab ref={lab} compact fps="10 60" prop:experiment={{ scene: 'ramp' }} class="wide"
        on:change={(event) => event.detail.experiments.length}>
        <slide-figure name="area-under-v" on:timeupdate={({ detail }) => detail.time.toFixed(1)} />
      </slide-lab>
    )
    // @ts-expect-error
    export const scene = <slide-lab scene="ramps" />
    // @ts-expect-error
    export const unknown = <slide-lab colour="red" />
    // @ts-expect-error
    export const event = <slide-lab on:timeupdate={({ detail }) => detail.time.length} />`,
  'vue.ts': `
    import type {} from 'any-frame-rate/vue'
    import type { GlobalComponents } from 'vue'
    type Lab = InstanceType<GlobalComponents['slide-lab']>['$props']
    type Figure = InstanceType<GlobalComponents['slide-figure']>['$props']
    export const lab: Lab = {
      ...{ compact: true, fps: '10 60', class: 'wide', key: 1 },
      experiment: { scene: 'ramp' },
      onChange: (event) => event.detail.experiments.length,
    }
    export const figure: Figure = {
      values: { step: 0.2 },
      onTimeupdate: ({ detail }) => detail.time.toFixed(1),
    }
    // @ts-expect-error
    export const scene: Lab = { scene: 'ramps' }
    // @ts-expect-error
    export const unknown: Lab = { colour: 'red' }
    // @ts-expect-error
    export const event: Lab = { onTimeupdate: ({ detail }) => detail.time.length }`,
}

/** Their names and shapes are those of @types/react 19 and solid-js 1.9. */
export const standIns = {
  'react/index.d.ts': `
    export interface RefObject<T> { current: T }
    export function useRef<T>(initial: T | null): RefObject<T | null>
    export interface Attributes { key?: string | null }
    export interface ClassAttributes<T> extends Attributes { ref?: RefObject<T | null> }
    export interface DOMAttributes<T> { children?: unknown; onChange?: (event: T) => void }
    export interface HTMLAttributes<T> extends DOMAttributes<T> { className?: string; slot?: string }
    export type DetailedHTMLProps<E extends HTMLAttributes<T>, T> = ClassAttributes<T> & E
    export namespace JSX {
      interface Element {}
      interface ElementChildrenAttribute { children: {} }
      interface IntrinsicElements { p: DetailedHTMLProps<HTMLAttributes<HTMLElement>, HTMLElement> }
    }`,
  'react/jsx-runtime.d.ts': `
    import type { JSX as ReactJSX } from './index'
    export namespace JSX {
      type Element = ReactJSX.Element
      type ElementChildrenAttribute = ReactJSX.ElementChildrenAttribute
      interface IntrinsicElements extends ReactJSX.IntrinsicElements {}
    }`,
  'solid-js/index.d.ts': `export type { JSX } from './jsx'`,
  'solid-js/jsx-runtime.d.ts': `export type { JSX } from './jsx'`,
  'solid-js/jsx.d.ts': `
    export namespace JSX {
      type Element = unknown
      interface ElementChildrenAttribute { children: {} }
      interface DOMAttributes<T> { children?: Element; ref?: T | ((element: T) => void) }
      interface HTMLAttributes<T> extends DOMAttributes<T> { class?: string }
      interface IntrinsicElements { p: HTMLAttributes<HTMLParagraphElement> }
    }`,
}
