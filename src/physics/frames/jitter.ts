import type { FrameClock, Frames } from '../frameClock.ts'
import type { NumberOption, Values } from '../options.ts'
import { Random } from '../random.ts'
import { fps, seed } from './options.ts'

const amount = {
  type: 'number',
  label: 'Jitter',
  symbol: 'j',
  unit: '',
  min: 0,
  max: 1,
  slider: { from: 0, to: 1, step: 0.05 },
  initial: 0.5,
} as const satisfies NumberOption

const options = { fps, amount, seed } as const

/** Frame times scatter evenly around their mean. */
export const jitter = {
  id: 'jitter',
  label: 'Jitter',
  about: 'Each frame is longer or shorter by chance, within (1 ± amount)/fps.',
  options,
  frames: ({ fps }: Values<typeof options>, duration: number) => fps * duration,
  start: (chosen: Values<typeof options>): Frames => new JitterFrames(chosen),
} as const satisfies FrameClock

const HALF = 2147483648

class JitterFrames implements Frames {
  duration = NaN
  time = 0
  private count = 0
  // In units of amount/(2³¹ fps): a sum of whole numbers, so that it is exact.
  private strayed = 0
  private readonly fps: number
  private readonly amount: number
  private readonly random: Random

  constructor({ fps, amount, seed }: Values<typeof options>) {
    this.fps = fps
    this.amount = amount
    this.random = new Random(seed)
  }

  next(): void {
    const stray = this.random.next() - HALF
    this.count++
    this.strayed += stray
    this.duration = (1 + this.amount * (stray / HALF)) / this.fps
    this.time = (this.count + this.amount * (this.strayed / HALF)) / this.fps
  }
}
