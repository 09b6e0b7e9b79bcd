import type { ReactiveController, ReactiveControllerHost } from 'lit'
import type { Trajectory } from '../physics/index.ts'

/** How long blocks take to glide from their old to their new places [ms]. */
const LENGTH = 350

/** With more rows than this to blend, a picture would take longer than a frame. */
const MOST_ROWS = 20_000

/**
 * Lets the blocks of a lab glide from where they were to where a change puts them, if motion is welcome. Only what is
 * drawn glides: the lab's state and its numbers are the new ones at once. Meanwhile the host has the attribute
 * `gliding`.
 */
export class Glide implements ReactiveController {
  private from: readonly Trajectory[] = []
  private began = 0
  private part = 0
  private request = 0
  private timer: ReturnType<typeof setTimeout> | undefined
  private readonly host: ReactiveControllerHost & HTMLElement

  constructor(host: ReactiveControllerHost & HTMLElement) {
    this.host = host
    host.addController(this)
  }

  hostDisconnected(): void {
    this.end()
  }

  /** Starts from runs as they were drawn, to those that the lab has by now. */
  begin(from: readonly Trajectory[], to: readonly Trajectory[]): void {
    this.end()
    if (from.every((each, i) => each === to[i])) return
    const rows = from.reduce((sum, { frames }) => sum + frames, 0)
    const isWelcome = matchMedia('(prefers-reduced-motion: no-preference)').matches
    if (!isWelcome || rows > MOST_ROWS) return
    this.from = from
    this.began = performance.now()
    this.part = 0
    this.host.toggleAttribute('gliding', true)
    this.request = requestAnimationFrame(this.tick)
    // A page that can't be seen gets no frames.
    this.timer = setTimeout(() => this.end(), 2 * LENGTH)
  }

  /** Everything is where it belongs, now. */
  end(): void {
    if (this.timer === undefined) return
    cancelAnimationFrame(this.request)
    clearTimeout(this.timer)
    this.timer = undefined
    this.from = []
    this.host.toggleAttribute('gliding', false)
    this.host.requestUpdate()
  }

  /** What is drawn at this moment of the visible runner with that index. */
  drawn(to: Trajectory, index: number): Trajectory {
    const from = this.from[index]
    return from ? blend(from, to, this.part * this.part * (3 - 2 * this.part)) : to
  }

  private readonly tick = (now: number): void => {
    this.part = Math.min(1, Math.max(0, (now - this.began) / LENGTH))
    if (this.part === 1) return this.end()
    this.request = requestAnimationFrame(this.tick)
    this.host.requestUpdate()
  }
}

/**
 * A run on its way from one to another, in the places that are drawn; all else is as in the one it goes to. Both have
 * the same frames; one that ended early stays where it ended.
 *
 * @param part of the way, 0 … 1
 */
export function blend(from: Trajectory, to: Trajectory, part: number): Trajectory {
  return {
    ...to,
    s: between(from.s, to.s, part),
    drawnS: between(from.drawnS, to.drawnS, part),
  }
}

function between(from: Float64Array, to: Float64Array, part: number): Float64Array {
  const last = from.length - 1
  // Two products, not a product of the difference, which may be too large for a number.
  return to.map((goal, row) => (1 - part) * from[Math.min(row, last)]! + part * goal)
}
