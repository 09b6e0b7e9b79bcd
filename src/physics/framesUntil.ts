import type { ResolvedExperiment } from './experiment.ts'
import type { Frames } from './frameClock.ts'
import { clockOf } from './frames/index.ts'
import { measure } from './measured.ts'

/** The frames of an experiment's clock, up to its duration: the last is cut there. */
export class FramesUntil {
  /** How long the frame lasts [s]. */
  length = NaN
  /** The wall-clock time at the frame's end [s]. */
  time = 0
  /**
   * How long the game takes the frame to be, and the sum of that [s]. Where it measures exactly, `length` and `time`.
   */
  delta = NaN
  measuredTime = 0
  /** About how many frames there will be. */
  readonly expected: number
  private readonly clock: Frames
  private readonly measured: Frames
  private readonly duration: number
  /** A frame that would leave no more than this is the last: the rounding of the clock's sums [s]. */
  private readonly slack: number

  constructor({ frames, duration }: Pick<ResolvedExperiment, 'frames' | 'duration'>) {
    const clock = clockOf(frames)
    this.clock = clock.start()
    this.measured = measure(frames, this.clock)
    this.expected = Math.ceil(clock.frames(duration))
    this.duration = duration
    this.slack = 4 * Number.EPSILON * duration
  }

  /** Goes on to the next frame. Returns false where there is none left. */
  next(): boolean {
    const { clock, measured, duration, slack } = this
    if (this.time >= duration) return false
    clock.next()
    const isLast = clock.time >= duration - slack
    const isCut = clock.time > duration + slack
    this.length = isCut ? duration - this.time : clock.duration
    this.time = isLast ? duration : clock.time
    this.delta = this.length
    this.measuredTime = this.time
    if (measured !== clock) {
      const before = measured.time
      measured.next()
      // Of a frame that is cut, the game measures the same part.
      const part = this.length / clock.duration
      this.delta = part * measured.duration
      this.measuredTime = isCut ? before + this.delta : measured.time
    }
    return true
  }
}
