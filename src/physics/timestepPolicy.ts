import type { Described, Options } from './options.ts'

/** One frame after another, as a timestep policy sees them. */
export interface FrameContext {
  /** How long the frame lasts, and the time on the wall clock at its end [s]. */
  readonly frameDuration: number
  readonly time: number
  /** The block; `dt` is for the policy to set [s]. */
  readonly motion: {
    readonly s: number
    readonly v: number
    dt: number
    readonly moving: boolean
    /** How long the last step went on until something happened in it, or to its end [s]. */
    readonly firstPart: number
  }
  /** The power of dt with which the method's error falls, whatever the law. */
  readonly order: number
  /** What the policy says of the frame: the time that the physics state stands at, the time dropped so far [s]. */
  stateTime: number
  lostTime: number
  /** The position to draw; a step sets it to where the block is [m]. */
  drawnS: number
  /** Takes that many steps of `motion.dt` seconds, `before` of them since the time that `stateTime` holds. */
  step(count?: number, before?: number): void
  /** Remembers how the run stands; `restore` returns to that, as often as it is called. */
  save(): void
  restore(): void
  /** What a policy that tries steps says of one: how far off it is and how far it may be [m], and what becomes of it. */
  error: number
  allowed: number
  judge(accepted: boolean): void
  /** Ends the run as diverged, where going on would take more work than a run may. */
  abandon(): void
}

/** Turns one frame into steps of the motion. */
export type Advance = (frame: FrameContext) => void

/** How physics time follows from frame time; `Choice` is what an experiment says of it. */
export interface TimestepPolicy<Choice = never> extends Described {
  readonly options: Options
  /** All of the frame time reaches the motion, sooner or later. */
  readonly losesTime: boolean
  /** About how many steps a run of that many seconds and frames asks for, at the most. */
  steps(choice: Choice, duration: number, frames: number): number
  start(choice: Choice): Advance
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
