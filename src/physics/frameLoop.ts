import { limits } from './experiment.ts'
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
  /** A frame that would leave no more than this is the last: the rounding of the clock's sums [s]. */
  private readonly slack: number
  private readonly mostEvaluations: number

  constructor(experiment: ResolvedExperiment, step?: typeof advance) {
    const { frames, duration, timestep } = experiment
    const clock = clockOf(frames)
    this.clock = clock.start()
    this.expectedFrames = Math.ceil(clock.frames(duration))
    this.duration = duration
    this.slack = 4 * Number.EPSILON * duration
    const { evaluations, evaluationsAFrame } = limits.toTolerance
    this.mostEvaluations =
      timestep.kind === 'tolerance'
        ? evaluations + evaluationsAFrame * this.expectedFrames
        : limits.evaluations
    this.run = new Run(experiment, step)
  }

  /**
   * Runs one frame more; the last is cut where the run ends. Gives the run up if it has taken more work than it may.
   * Returns false where there is none left.
   */
  next(): boolean {
    const { run, clock, duration, slack } = this
    if (run.time >= duration || run.ended) return false
    clock.next()
    const isLast = clock.time >= duration - slack
    const isCut = clock.time > duration + slack
    run.frameDuration = isCut ? duration - run.time : clock.duration
    run.time = isLast ? duration : clock.time
    run.advanceFrame()
    // What no forecast of the work has seen coming, such as a step cut into thousands.
    if (run.evaluations > this.mostEvaluations) run.abandon()
    return true
  }
}
