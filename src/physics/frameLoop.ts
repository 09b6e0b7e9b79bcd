import type { ResolvedExperiment } from './experiment.ts'
import type { FrameClock, Frames } from './frameClock.ts'
import { frameClocks } from './frames/index.ts'
import { entry } from './lists.ts'
import { Run } from './run.ts'
import type { Watch } from './run.ts'

/** A run driven by its experiment's own clock, up to its duration. */
export class FrameLoop {
  readonly run: Run
  private readonly frames: Frames
  private readonly duration: number

  constructor(experiment: ResolvedExperiment, watch?: Watch) {
    const clock: FrameClock = entry(frameClocks, experiment.frames.kind)
    this.frames = clock.start(experiment.frames as never)
    this.duration = experiment.duration
    this.run = new Run(experiment, watch)
  }

  /** There is a frame left to run. */
  get goesOn(): boolean {
    return this.run.time < this.duration && !this.run.ended
  }

  /** Runs one frame more, which is cut where the run ends. */
  next(): void {
    const { run, frames, duration } = this
    frames.next()
    // A frame that would leave only rounding behind it is the last.
    const slack = 1e-9 * frames.duration
    const over = frames.time - duration
    run.frameDuration = over > slack ? duration - run.time : frames.duration
    run.time = over >= -slack ? duration : frames.time
    run.advanceFrame()
  }
}
