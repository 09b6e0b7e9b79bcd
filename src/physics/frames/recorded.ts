import { ExactSum } from '../exactSum.ts'
import type { FrameClock, Frames } from '../frameClock.ts'
import type { ListOption, Values } from '../options.ts'

const durations = {
  type: 'list',
  label: 'Frame times',
  unit: 's',
  min: 1e-5,
  max: 60,
  maxLength: 100_000,
  initial: [1 / 60],
} as const satisfies ListOption

const options = { durations } as const

/** Frame times measured somewhere, played again from the start when they run out. */
export const recorded = {
  id: 'recorded',
  label: 'Recorded',
  about: 'Frame times of a real machine, repeated when they run out.',
  options,
  frames: ({ durations }: Values<typeof options>, duration: number) => {
    let time = 0
    for (let i = 0; i < durations.length; i++) {
      if (time >= duration) return i + 1
      time += durations[i]!
    }
    // Whatever round is cut short may have its shortest frames first.
    return (duration / time + 1) * durations.length
  },
  start: ({ durations }: Values<typeof options>): Frames => new RecordedFrames(durations),
} as const satisfies FrameClock

class RecordedFrames implements Frames {
  duration = NaN
  time = 0
  private upcoming = 0
  private readonly sum = new ExactSum()
  private readonly durations: readonly number[]

  constructor(durations: readonly number[]) {
    this.durations = durations
  }

  next(): void {
    this.duration = this.durations[this.upcoming]!
    this.upcoming = (this.upcoming + 1) % this.durations.length
    this.sum.add(this.duration)
    this.time = this.sum.value
  }
}
