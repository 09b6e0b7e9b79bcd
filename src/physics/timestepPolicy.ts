import type { Described, Options } from './options.ts'
import type { Run } from './run.ts'

/** Turns one frame of a run into steps of the motion: reads `run.frameDuration` and `run.time`, calls `run.step`. */
export type Advance = (run: Run) => void

/** How physics time follows from frame time. */
export interface TimestepPolicy extends Described {
  readonly options: Options
  /** All of the frame time reaches the motion, sooner or later. */
  readonly losesTime: boolean
  /** About how many steps a run of that many seconds and frames asks for, at the most. */
  steps(options: never, duration: number, frames: number): number
  /** Each frame is one step as long as the frame, and nothing else: frames may be taken in a row. */
  readonly stepIsFrame?: true
  start(options: never): Advance
}

/**
 * More steps than any frame needs and few enough to be over at once (about a millisecond): where a policy names no
 * bound of its own, what a frame would need beyond it is dropped and reported as lost time.
 */
export const MOST_STEPS_A_FRAME = 100000

/** How many whole steps fit in a time, both given in seconds: 1 s holds sixty steps of 1/60 s, whatever their rounding. */
export function wholeSteps(time: number, step: number): number {
  const steps = time / step
  // Each of the two times and their ratio is off by half an ulp at most.
  return Math.floor(steps + 4 * Number.EPSILON * steps)
}
