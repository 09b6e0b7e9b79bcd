import type { Described, Options } from './options.ts'

/** One frame after another, as a timestep policy sees them. */
export interface FrameContext {
  /**
   * By how much the game's time goes on in the frame, and where it stands at the frame's end [s]: the frames' lengths as the
   * game measures them, times the time scale.
   */
  readonly frameDuration: number
  readonly gameTime: number
  readonly timeScale: number
  /** The block; `dt` is for the policy to set [s]. */
  readonly motion: {
    readonly s: number
    readonly v: number
    dt: number
    readonly moving: boolean
    readonly evaluations: number
  }
  /** The power of dt with which the method's error falls, also where the force depends on v. */
  readonly order: number
  /** Set by the policy: the time of the physics state, and the time dropped so far [s]. */
  stateTime: number
  lostTime: number
  /** The position to draw; a step sets it to where the block is [m]. */
  drawnS: number
  /** Takes `count` steps of `motion.dt` seconds, after `before` earlier ones since the time in `stateTime`. */
  step(count?: number, before?: number): void
  /**
   * Takes one step of `motion.dt` seconds, or up to where the stopping rule ends it; leaves its length in `motion.dt`.
   */
  stepToEvent(): void
  /** Takes a snapshot of the run; each call of `restore` returns to it. */
  save(): void
  restore(): void
  /**
   * Set by a policy that tries steps: a try's length [s], its error and its tolerance [m]; and whether it is accepted.
   */
  tried: number
  error: number
  allowed: number
  judge(accepted: boolean): void
  /** Ends the run as diverged, because it would take more work than a run may. */
  abandon(): void
}

/** Turns one frame into steps of the motion. */
export type Advance = (frame: FrameContext) => void

/** How frame time becomes physics time; `Choice` is the JSON with which an experiment chooses it. */
export interface TimestepPolicy<Choice = never> extends Described {
  readonly options: Options
  /** Part of the frame time may never reach the motion. */
  readonly losesTime: boolean
  /** An approximate upper bound on the steps of a run of `duration` seconds and `frames` frames. */
  steps(choice: Choice, duration: number, frames: number): number
  start(choice: Choice): Advance
}

/**
 * More steps than any frame needs, and few enough to finish in about a millisecond. Where a policy has no
 * bound of its own, the time beyond this is dropped and reported as lost.
 */
export const MOST_STEPS_A_FRAME = 100000

/** The number of whole steps in a time, both in seconds: 1 s holds sixty steps of 1/60 s, despite rounding. */
export function wholeSteps(time: number, step: number): number {
  const steps = time / step
  // The two times and their ratio each have a rounding error of at most half an ulp.
  return Math.floor(steps + 4 * Number.EPSILON * steps)
}
