import { limits } from './experiment.ts'
import type { ResolvedExperiment } from './experiment.ts'
import { FramesUntil } from './framesUntil.ts'
import { Run } from './run.ts'
import type { advance } from './step.ts'

/** A run driven by its experiment's own clock, up to its duration. */
export class FrameLoop {
  readonly run: Run
  private readonly frames: FramesUntil
  private readonly mostEvaluations: number

  constructor(experiment: ResolvedExperiment, step?: typeof advance) {
    this.frames = new FramesUntil(experiment)
    this.run = new Run(experiment, step)
    const { evaluationsAnOrder, evaluationsAFrame } = limits.toTolerance
    this.mostEvaluations =
      experiment.timestep.kind === 'tolerance'
        ? evaluationsAnOrder * Math.min(this.run.order, 2) + evaluationsAFrame * this.expectedFrames
        : limits.evaluations
  }

  /** About how many frames it will have. */
  get expectedFrames(): number {
    return this.frames.expected
  }

  /**
   * Runs one frame more; the last is cut where the run ends. Gives the run up if it has taken more work than it may.
   * Returns false where there is none left.
   */
  next(): boolean {
    const { run, frames } = this
    if (run.ended || !frames.next()) return false
    run.time = frames.time
    run.frameDuration = run.timeScale * frames.delta
    run.gameTime = run.timeScale * frames.measuredTime
    run.advanceFrame()
    // What no forecast of the work has seen coming, such as a step cut into thousands.
    if (run.evaluations > this.mostEvaluations) run.abandon()
    return true
  }
}
