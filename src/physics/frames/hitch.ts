import type { FrameClock, Frames } from '../frameClock.ts'
import type { NumberOption, Values } from '../options.ts'
import { fps } from './options.ts'

const every = {
  type: 'number',
  label: 'A hitch every',
  symbol: 'T',
  unit: 's',
  min: 0.01,
  max: 3600,
  slider: { from: 0.1, to: 5, step: 0.1 },
  initial: 1,
} as const satisfies NumberOption

const length = {
  type: 'number',
  label: 'lasting',
  symbol: 'h',
  unit: 's',
  min: 0.001,
  max: 60,
  slider: { from: 0.05, to: 2, step: 0.05 },
  initial: 0.25,
} as const satisfies NumberOption

const options = { fps, every, length } as const

/** Steady frames, and a long one now and then: a level loads, a collector runs. */
export const hitch = {
  id: 'hitch',
  label: 'Hitches',
  about: 'Steady frames with a long one now and then: a level loads, memory is freed.',
  options,
  frames: ({ fps, every, length }: Values<typeof options>, duration: number) => {
    const rate = (plain: number, hitches: number) =>
      (plain + hitches) / (plain / fps + hitches * length)
    const rest = every * Math.ceil(length / every) - length
    // Where hardly a frame fits between a hitch and the next that is due, some hitches miss their turn and some follow at
    // once: anything from the fewest to the most plain frames lies between two.
    const most =
      rest * fps < 1
        ? Math.max(length < every ? rate(1, 2) : rate(0, 1), rate(every * fps + 1, 1))
        : rate(rest * fps, 1)
    // A run begins with plain frames: it is ahead of its rate by those of one hitch at the most, and by one.
    return most * duration + fps * length + 1
  },
  start: (chosen: Values<typeof options>): Frames => new HitchFrames(chosen),
} as const satisfies FrameClock

class HitchFrames implements Frames {
  duration = NaN
  time = 0
  private plain = 0
  private hitches = 0
  private due: number
  private readonly chosen: Values<typeof options>

  constructor(chosen: Values<typeof options>) {
    this.chosen = chosen
    this.due = chosen.every
  }

  next(): void {
    const { fps, every, length } = this.chosen
    const stalls = this.time >= this.due
    if (stalls) this.hitches++
    else this.plain++
    this.duration = stalls ? length : 1 / fps
    this.time = this.plain / fps + this.hitches * length
    if (stalls) this.due = every * Math.ceil(this.time / every)
  }
}
