import type { AttributePart, ChildPart, PropertyPart } from 'lit'
import { AsyncDirective, directive } from 'lit/async-directive.js'
import type { UpdatePhase } from './subscribers.ts'
import type { Playback } from './playback.ts'

/** One place in a template whose value follows the cursor on time, without anything else being rendered. */
class AtNow extends AsyncDirective {
  protected readonly phase: UpdatePhase = 'write'
  private playback: Playback | undefined
  private of: ((time: number) => unknown) | undefined
  private shown: unknown
  private element: Element | undefined
  private stop: (() => void) | undefined

  override render(playback: Playback, of: (time: number) => unknown): unknown {
    return of(playback.time)
  }

  override update(
    part: AttributePart | ChildPart | PropertyPart,
    [playback, of]: Parameters<this['render']>,
  ): unknown {
    this.element = 'element' in part ? part.element : (part.parentNode as Element)
    this.of = of
    if (playback !== this.playback) {
      this.disconnected()
      this.playback = playback
      if (this.isConnected) this.reconnected()
    }
    return (this.shown = this.render(playback, of))
  }

  protected override reconnected(): void {
    this.stop = this.playback!.subscribe(this.element!, this.phase, this.follow)
  }

  protected override disconnected(): void {
    this.stop?.()
  }

  private readonly follow = (): void => {
    const value = this.of!(this.playback!.time)
    if (value === this.shown) return
    this.shown = value
    this.setValue(value)
  }
}

/** For what moves rather than changes: it follows at every frame, and all else a few times a second. */
class MovedAtNow extends AtNow {
  protected override readonly phase = 'move'
}

/** Renders a function of a playback's instant [s] as text, updated a few times a second while it is visible. */
export const atNow = directive(AtNow)

/** Like `atNow`, updated at every frame: for things that move. */
export const movedAtNow = directive(MovedAtNow)
