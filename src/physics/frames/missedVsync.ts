import type { FrameClock, Frames } from '../frameClock.ts'
import type { Values } from '../options.ts'
import { Random } from '../random.ts'
import { fps, seed } from './options.ts'

const options = { fps, seed } as const

/** The display refreshes steadily, but the game misses some refreshes, by chance. */
export const missedVsync = {
  id: 'missed-vsync',
  label: 'Missed vsync',
  about:
    'The display refreshes steadily; a frame that is not ready waits for the next refresh, so it lasts one or two, by chance.',
  options,
  frames: ({ fps }: Values<typeof options>, duration: number) => (fps / 1.5) * duration,
  start: (chosen: Values<typeof options>): Frames => new MissedVsyncFrames(chosen),
} as const satisfies FrameClock

class MissedVsyncFrames implements Frames {
  duration = NaN
  time = 0
  private refreshes = 0
  private readonly fps: number
  private readonly random: Random

  constructor({ fps, seed }: Values<typeof options>) {
    this.fps = fps
    this.random = new Random(seed)
  }

  next(): void {
    const refreshes = this.random.next() < 2147483648 ? 1 : 2
    this.refreshes += refreshes
    this.duration = refreshes / this.fps
    this.time = this.refreshes / this.fps
  }
}
