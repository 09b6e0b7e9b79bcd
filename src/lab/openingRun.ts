import type { ReactiveController, ReactiveControllerHost } from 'lit'
import type { Moving } from './playback/atNow.ts'
import type { Playback } from './playback/playback.ts'
import type { UpdatePhase } from './playback/subscribers.ts'

/** How long the spread takes to count up once the blocks have stopped [s]. */
const COUNTING = 0.6

/** While the page still loads, frames are late; the blocks do not leap then [s]. */
const LONGEST_FRAME = 0.1

/** Any of these on the lab ends it. */
const touches = ['pointerdown', 'keydown', 'wheel', 'click'] as const

/** The number that counts up, without the lab being rendered for it: `time` is the part of it that is shown, 0 … 1. */
export class Counting implements Moving {
  time = 1
  private readonly listeners = new Set<() => void>()

  subscribe(_element: Element, _phase: UpdatePhase, listener: () => void): () => void {
    this.listeners.add(listener)
    return () => this.listeners.delete(listener)
  }

  to(time: number): void {
    this.time = time
    for (const listener of this.listeners) listener()
  }
}

/**
 * Plays the opening of the page once, when its picture is first seen: the blocks run from start to end, then the spread
 * counts up. A touch, a print or a change ends it at once, with everything at its end.
 */
export class OpeningRun implements ReactiveController {
  readonly counting = new Counting()
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

  /**
   * Plays as soon as half of the picture is in the window, if motion is welcome; not before the lab is whole, since what
   * is loaded and laid out meanwhile would hold up its frames.
   */
  playWhenSeen(picture: Element, whole: Promise<unknown>): void {
    if (!matchMedia('(prefers-reduced-motion: no-preference)').matches) return
    const seen = new IntersectionObserver(
      (entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return
        seen.disconnect()
        this.begin()
      },
      { threshold: 0.5 },
    )
    this.watching = new AbortController()
    const { signal } = this.watching
    signal.addEventListener('abort', () => seen.disconnect())
    const watch = () => {
      if (!signal.aborted) seen.observe(picture)
    }
    // What can't be loaded says so elsewhere.
    whole.then(watch, watch)
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
    this.counting.time = 0
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
    this.counting.time = 1
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
      const counted = this.counting.time + passed / COUNTING
      // What is out of sight has not followed.
      if (counted >= 1) return this.end()
      this.counting.to(counted)
    }
    this.request = requestAnimationFrame(this.tick)
  }

  private show(time: number): void {
    this.playback.show(time)
    this.shown = this.playback.time
  }
}
