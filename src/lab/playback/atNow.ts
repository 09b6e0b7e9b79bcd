import type { AttributePart, ChildPart, PropertyPart } from 'lit'
import { AsyncDirective, directive } from 'lit/async-directive.js'
import type { UpdatePhase } from './subscribers.ts'

/** What has an instant that moves: a playback, for one. */
export interface Moving {
  readonly time: number
  /** Calls whenever the instant has moved; returns a function that unsubscribes. */
  subscribe(element: Element, phase: UpdatePhase, listener: () => void): () => void
}

/** One place in a template whose value follows an instant, without anything else being rendered. */
class AtNow extends AsyncDirective {
  protected readonly phase: UpdatePhase = 'write'
  private moving: Moving | undefined
  private of: ((time: number) => unknown) | undefined
  private shown: unknown
  private element: Element | undefined
  private stop: (() => void) | undefined

  override render(moving: Moving, of: (time: number) => unknown): unknown {
    return of(moving.time)
  }

  override update(
    part: AttributePart | ChildPart | PropertyPart,
    [moving, of]: Parameters<this['render']>,
  ): unknown {
    this.element = 'element' in part ? part.element : (part.parentNode as Element)
    this.of = of
    if (moving !== this.moving) {
      this.disconnected()
      this.moving = moving
      if (this.isConnected) this.reconnected()
    }
    return (this.shown = this.render(moving, of))
  }

  protected override reconnected(): void {
    this.stop = this.moving!.subscribe(this.element!, this.phase, this.follow)
  }

  protected override disconnected(): void {
    this.stop?.()
  }

  private readonly follow = (): void => {
    const value = this.of!(this.moving!.time)
    if (value === this.shown) return
    this.shown = value
    this.setValue(value)
  }
}

/** For what moves rather than changes: it follows at every frame, and all else a few times a second. */
class MovedAtNow extends AtNow {
  protected override readonly phase = 'move'
}

/** Renders a function of an instant that moves: a playback's [s], updated a few times a second while it is visible. */
export const atNow = directive(AtNow)

/** Like `atNow`, updated at every frame: for things that move. */
export const movedAtNow = directive(MovedAtNow)
