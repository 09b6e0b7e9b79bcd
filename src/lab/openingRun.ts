import type { ReactiveController, ReactiveControllerHost } from 'lit'
import type { Playback } from './playback/playback.ts'

/** How long the spread takes to count up once the blocks have stopped [s]. */
const COUNTING = 0.6

/** While the page still loads, frames are late; the blocks do not leap then [s]. */
const LONGEST_FRAME = 0.1

/** Any of these on the lab ends it. */
const touches = ['pointerdown', 'keydown', 'wheel', 'click'] as const

/**
 * Plays the opening of the page once, when its picture is first seen: the blocks run from start to end, then the spread
 * counts up. A touch, a print or a change ends it at once, with everything at its end.
 */
export class OpeningRun implements ReactiveController {
  /** The part of the spread that is shown, 0 … 1. */
  counted = 1
  private shown = Infinity
  private before = NaN
  private request = 0
  private watching: AbortController | undefined
  private readonly host: ReactiveControllerHost & HTMLElement
  private readonly playback: Playback

  constructor(host: ReactiveControllerHost & HTMLElement, playback: Playback) {
    this.host = host
    this.playback = playback
    host.addController(this)
  }

  hostDisconnected(): void {
    this.end()
  }

  /** Plays as soon as half of the picture is in the window, if motion is welcome. */
  playWhenSeen(picture: Element): void {
    if (!matchMedia('(prefers-reduced-motion: no-preference)').matches) return
    const seen = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return
        seen.disconnect()
        this.begin()
      },
      { threshold: 0.5 },
    )
    seen.observe(picture)
    this.watching = new AbortController()
    const { signal } = this.watching
    signal.addEventListener('abort', () => seen.disconnect())
    const end = () => this.end()
    for (const type of touches)
      this.host.addEventListener(type, end, { signal, capture: true, passive: true })
    addEventListener('beforeprint', end, { signal })
  }

  /** Shows the end, now and from now on. */
  end(): void {
    const { isPlaying } = this
    this.stop()
    if (isPlaying) this.playback.toEnd()
  }

  private get isPlaying(): boolean {
    return this.request !== 0
  }

  private begin(): void {
    this.counted = 0
    this.host.requestUpdate()
    this.show(0)
    this.request = requestAnimationFrame(this.tick)
  }

  private stop(): void {
    this.watching?.abort()
    this.watching = undefined
    if (!this.isPlaying) return
    cancelAnimationFrame(this.request)
    this.request = 0
    this.counted = 1
    this.host.requestUpdate()
  }

  private readonly tick = (now: number): void => {
    const { playback } = this
    // Somebody else has moved the cursor.
    if (playback.playing || playback.time !== this.shown) return this.stop()
    const passed = Math.min(LONGEST_FRAME, (now - this.before) / 1000 || 0)
    this.before = now
    if (!playback.isAtEnd) this.show(this.shown + passed)
    else {
      this.counted += passed / COUNTING
      // What is out of sight has not followed.
      if (this.counted >= 1) return this.end()
      this.host.requestUpdate()
    }
    this.request = requestAnimationFrame(this.tick)
  }

  private show(time: number): void {
    this.playback.show(time)
    this.shown = this.playback.time
  }
}
