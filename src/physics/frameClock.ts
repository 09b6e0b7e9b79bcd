import type { Described, Options } from './options.ts'

/** One run of a clock: each `next` is a frame. Time is counted in whole frames wherever the clock allows it. */
export interface Frames {
  /** How long the frame lasts [s]. */
  duration: number
  /** The wall-clock time at the frame's end [s]. */
  time: number
  next(): void
}

/** A rule for the lengths of frames; `Choice` is the JSON with which an experiment chooses it. */
export interface FrameClock<Choice = never> extends Described {
  readonly options: Options
  /** The largest number of frames in a run of `duration` seconds; a random clock may exceed it by a few. */
  frames(choice: Choice, duration: number): number
  start(choice: Choice): Frames
}
