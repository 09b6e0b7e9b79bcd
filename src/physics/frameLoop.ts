import type { ResolvedExperiment } from './experiment.ts'
import type { Frames } from './frameClock.ts'
import { clockOf } from './frames/index.ts'
import { Run } from './run.ts'
import type { advance } from './step.ts'

/** A run driven by its experiment's own clock, up to its duration. */
export class FrameLoop {
  readonly run: Run
  /** About how many frames it will have. */
  readonly expectedFrames: number
  private readonly clock: Frames
  private readonly duration: number
  /** The rounding of the clock's sums: a frame that would leave no more time than this is the last [s]. */
  private readonly slack: number

  constructor(experiment: ResolvedExperiment, step?: typeof advance) {
    const { frames, duration } = experiment
    const clock = clockOf(frames)
    this.clock = clock.start()
    this.expectedFrames = Math.ceil(clock.frames(duration))
    this.duration = duration
    this.slack = 4 * Number.EPSILON * duration
    this.run = new Run(experiment, step)
  }

  /** Runs one more frame, cut at the end of the run if it is the last. Returns false if none is left. */
  next(): boolean {
    const { run, clock, duration, slack } = this
    if (run.time >= duration || run.ended) return false
    clock.next()
    const isLast = clock.time >= duration - slack
    const isCut = clock.time > duration + slack
    run.frameDuration = isCut ? duration - run.time : clock.duration
    run.time = isLast ? duration : clock.time
    run.advanceFrame()
    return true
  }
}
