import type { ResolvedExperiment } from './experiment.ts'
import type { FrameClock, Frames } from './frameClock.ts'
import { frameClocks } from './frames/index.ts'
import { entry } from './lists.ts'
import { Run } from './run.ts'
import type { Watch } from './stepper.ts'
import type { Recorder } from './trajectory.ts'

/** So many frames are read from the clock at once. */
const AHEAD = 1024

/** A run driven by its experiment's own clock, up to its duration. */
export class FrameLoop {
  readonly run: Run
  private readonly clock: Frames
  private readonly duration: number
  // Frames that have been read: how long each lasts, when it ends [s], and which of them are still to run.
  private readonly lengths = new Float64Array(AHEAD + 1)
  private readonly times = new Float64Array(AHEAD)
  private longest = 0
  private shortest = 0
  private upcoming = 0
  private read = 0
  /** The last frame that was read is the run's last. */
  private complete = false

  constructor(experiment: ResolvedExperiment, watch?: Watch) {
    const clock: FrameClock = entry(frameClocks, experiment.frames.kind)
    this.clock = clock.start(experiment.frames as never)
    this.duration = experiment.duration
    this.run = new Run(experiment, watch)
  }

  /** There is a frame left to run. */
  get goesOn(): boolean {
    return this.run.time < this.duration && !this.run.ended
  }

  /** Runs frames in a row as long as nothing happens in them, and records them. Leaves one frame at least for `next`. */
  row(recorder: Recorder): void {
    if (!this.run.stepIsFrame) return
    this.readAhead()
    const { run, lengths, times, upcoming } = this
    const most = Math.min(this.read - upcoming - 1, recorder.room)
    // A frame of no length moves nothing: not even a row.
    if (most < 1 || !(this.shortest > 0)) return
    recorder.lengths = lengths.subarray(upcoming)
    recorder.each = this.shortest === this.longest ? this.longest : Infinity
    const taken = run.frameRow(most, recorder)
    if (taken === 0) return
    this.upcoming = upcoming + taken
    recorder.timeRow(times.subarray(upcoming, this.upcoming))
    run.time = run.stateTime = times[this.upcoming - 1]!
  }

  /** Runs one frame more, which is cut where the run ends. */
  next(): void {
    this.readAhead()
    const { run, duration } = this
    const last = this.complete && this.upcoming === this.read - 1
    const length = this.lengths[this.upcoming]!
    const time = this.times[this.upcoming++]!
    run.frameDuration = last && time - duration > slack(length) ? duration - run.time : length
    run.time = last ? duration : time
    run.advanceFrame()
  }

  private readAhead(): void {
    if (this.upcoming < this.read) return
    const { clock, lengths, times, duration } = this
    let read = 0
    let longest = 0
    let shortest = Infinity
    let complete = false
    while (!complete && read < AHEAD) {
      clock.next()
      const length = clock.duration
      const { time } = clock
      lengths[read] = length
      times[read++] = time
      if (length > longest) longest = length
      if (length < shortest) shortest = length
      complete = time >= duration - slack(length)
    }
    this.longest = longest
    this.shortest = shortest
    this.complete = complete
    this.upcoming = 0
    this.read = read
  }
}

/** A frame that would leave only rounding behind it is the last. */
function slack(length: number): number {
  return 1e-9 * length
}
