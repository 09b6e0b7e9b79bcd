import { html } from 'lit'
import type { LitElement, ReactiveControllerHost, TemplateResult } from 'lit'
import { pointIn } from '../../ui/input.ts'

/** Where a key goes in a picture: so many steps to the right, and so many up. */
export type Move = readonly [across: number, up: number]

/** The keys that go one step in a picture. */
export const arrows: Readonly<Record<string, Move>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
}

/** A picture of things that can be chosen. */
interface ChoicePicture<Thing> {
  /** For screen readers: what it shows, and what its keys do. */
  readonly label: string
  /** Where its keys go, by name. */
  readonly moves: Readonly<Record<string, Move>>
  /** What is at a place [px], if anything is. */
  readonly at: (x: number, y: number) => Thing | undefined
  /** What a key goes to, with Shift by more; nothing where there is nothing to go to. */
  readonly next: (from: Thing | undefined, move: Move, shift: boolean) => Thing | undefined
  /** What a thing says, for those who go there by keys. */
  readonly words: (thing: Thing) => string
  /** What a click does, or Enter and the space bar to what is chosen: answers whether the key was the picture's. */
  readonly show: (thing: Thing | undefined) => boolean
}

/** What of a picture is chosen: what is at the pointer, or where keys went. */
export interface PictureChoice<Thing> {
  chosen: Thing | undefined
  /** The same in words, for those who went there by keys. */
  told: string
  choose(thing: Thing | undefined): void
  /** The picture, in which things are chosen. */
  area(content: unknown): TemplateResult
}

/** Lets things be chosen in a picture, whose element is drawn again with each. */
export function pictureChoice<Thing>(
  host: ReactiveControllerHost,
  { label, moves, at, next, words, show }: ChoicePicture<Thing>,
): PictureChoice<Thing> {
  const under = (event: MouseEvent) => {
    const { x, y } = pointIn(event.currentTarget as HTMLElement, event)
    return at(x, y)
  }
  const pressed = (event: KeyboardEvent) => {
    const { key, ctrlKey, metaKey, altKey, shiftKey } = event
    if (ctrlKey || metaKey || altKey) return
    const move = moves[key]
    if (key === 'Enter' || key === ' ') {
      if (!show(choice.chosen)) return
    } else {
      const thing = move && next(choice.chosen, move, shiftKey)
      if (!thing) return
      choice.told = words(thing)
      choice.chosen = thing
      host.requestUpdate()
    }
    // The lab's own keys move its transport.
    event.preventDefault()
    event.stopPropagation()
  }
  const choice: PictureChoice<Thing> = {
    chosen: undefined,
    told: '',
    choose(thing) {
      if (thing === choice.chosen) return
      choice.chosen = thing
      host.requestUpdate()
    },
    area: (content) =>
      html`<div
        class="area"
        role="group"
        tabindex="0"
        aria-label=${label}
        @pointermove=${(event: PointerEvent) => choice.choose(under(event))}
        @pointerleave=${() => choice.choose(undefined)}
        @click=${(event: MouseEvent) => show(under(event))}
        @keydown=${pressed}
      >
        ${content}
      </div>`,
  }
  return choice
}

/**
 * Follows the size of the `.area` in an element, which is drawn again when its width is another; its height follows
 * from that.
 *
 * @returns the size as it is at any time, the width to a whole pixel [px]
 */
export function areaSize(host: LitElement): { readonly width: number; readonly height: number } {
  const size = { width: 0, height: 0 }
  const observer = new ResizeObserver(([entry]) => {
    const { width, height } = entry!.contentRect
    size.height = height
    if (Math.round(width) === size.width) return
    size.width = Math.round(width)
    host.requestUpdate()
  })
  host.addController({
    hostUpdated: () => observer.observe(host.querySelector('.area')!),
    hostDisconnected: () => observer.disconnect(),
  })
  return size
}
