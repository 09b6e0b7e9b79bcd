import type { Described, Options } from './options.ts'

/** One run of a clock: each `next` is a frame. Time is counted in whole frames wherever the clock allows it. */
export interface Frames {
  /** How long the frame lasts [s]. */
  duration: number
  /** The wall-clock time at the frame's end [s]. */
  time: number
  next(): void
}

/** A way in which frames follow each other; `Choice` is what an experiment says of it. */
export interface FrameClock<Choice = never> extends Described {
  readonly options: Options
  /** How many frames a run of that many seconds has at the most; chance may add a few. */
  frames(choice: Choice, duration: number): number
  start(choice: Choice): Frames
}
