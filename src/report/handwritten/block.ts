/** A scene's parameters, `position` and `speed` among them. */
export type Given = Readonly<Record<string, number>>

/** What somebody would write by hand for one scene and one method, with the duties that a call of `run.frame` has. */
export interface HandwrittenBlock {
  /** Distance along the track [m] and speed [m/s]. */
  readonly s: number
  readonly v: number
  /** What friction has turned into heat [J]. */
  readonly heat: number
  readonly clock: HandwrittenClock
  /** To which side the block slides; 0: it rests, has left the track or has diverged. */
  readonly slip: -1 | 0 | 1
  /**
   * Moves on by `count` frames of `dt` seconds, past every stop in them, and no further than the end of the track. Each loop
   * has this of its own, so that V8 compiles its frame into it.
   */
  frames(count: number, dt: number): void
}

/** A sum of frame times that stays exact to one rounding over millions of frames (two-sum). */
export class HandwrittenClock {
  private high = -0
  private low = -0

  /** [s] */
  get time(): number {
    return this.high + this.low
  }

  add(dt: number): void {
    const sum = this.high + dt
    const added = sum - this.high
    this.low += this.high - (sum - added) + (dt - added)
    this.high = sum
  }
}

/** Only a step that has lost its stability gets this far [m]. */
export const FAR = 1e24

/**
 * The slip direction for a speed and, at rest, for the tangential acceleration, of which static friction holds `hold`.
 */
export function slipDirection(v: number, tangential: number, hold: number): -1 | 0 | 1 {
  if (v !== 0) return v > 0 ? 1 : -1
  return Math.abs(tangential) <= hold ? 0 : tangential > 0 ? 1 : -1
}
