import type { ResolvedExperiment } from './experiment.ts'
import { FramesUntil } from './framesUntil.ts'
import { Run } from './run.ts'
import type { advance } from './step.ts'

/** A run driven by its experiment's own clock, up to its duration. */
export class FrameLoop {
  readonly run: Run
  private readonly frames: FramesUntil

  constructor(experiment: ResolvedExperiment, step?: typeof advance) {
    this.frames = new FramesUntil(experiment)
    this.run = new Run(experiment, step)
  }

  /** About how many frames it will have. */
  get expectedFrames(): number {
    return this.frames.expected
  }

  /** Runs one frame more; the last is cut where the run ends. Returns false where there is none left. */
  next(): boolean {
    const { run, frames } = this
    if (run.ended || !frames.next()) return false
    run.frameDuration = frames.length
    run.time = frames.time
    run.advanceFrame()
    return true
  }
}
