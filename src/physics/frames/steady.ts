import type { FrameClock, Frames } from '../frameClock.ts'
import type { Values } from '../options.ts'
import { fps } from './options.ts'

const options = { fps } as const

/** Every frame lasts as long as every other. */
export const steady = {
  id: 'steady',
  label: 'Steady',
  about: 'Every frame is as long as the last: the frames of a textbook.',
  options,
  frames: ({ fps }: Values<typeof options>, duration: number) => fps * duration,
  start: ({ fps }: Values<typeof options>): Frames => new SteadyFrames(fps),
} as const satisfies FrameClock

class SteadyFrames implements Frames {
  duration: number
  time = 0
  private count = 0
  private readonly fps: number

  constructor(fps: number) {
    this.fps = fps
    this.duration = 1 / fps
  }

  next(): void {
    this.count++
    this.time = this.count / this.fps
  }
}
