import type { ResolvedExperiment } from './experiment.ts'
import type { FrameClock, Frames } from './frameClock.ts'
import { frameClocks } from './frames/index.ts'
import { entry } from './lists.ts'
import { Run } from './run.ts'
import type { Watch } from './run.ts'
import type { Recorder } from './trajectory.ts'

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

  /**
   * Runs frames in a row as long as all last equally long and nothing happens in them, and records them. Leaves one frame at
   * least for `next`.
   */
  row(recorder: Recorder): void {
    const { run, frames, duration } = this
    if (!frames.even) return
    // The last frame may be cut, and rounding may make one frame more or less of the time that is left.
    const whole = Math.floor((duration - run.time) / frames.duration) - 1
    run.frameDuration = frames.duration
    const taken = run.frameRow(Math.min(whole, recorder.room), recorder)
    if (taken === 0) return
    recorder.timeRow(taken, frames)
    run.time = run.stateTime = frames.time
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
