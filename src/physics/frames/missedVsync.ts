import type { FrameClock, Frames } from '../frameClock.ts'
import type { Values } from '../options.ts'
import { Random } from '../random.ts'
import { fps, seed } from './options.ts'

const options = { fps, seed } as const

/**
 * A display that refreshes steadily, and a game that misses some refreshes: a channel that loses packets in bursts
 * (Gilbert, 1960; Elliott, 1963). Before each frame, the game gets busy with probability 1/32, or is done with
 * probability 1/4. While it is busy, a frame takes one refresh with probability 1/4, two with 1/2, three with 1/4;
 * otherwise it takes one. So it is busy for a ninth of all frames, four at a time, and the mean frame takes 10/9 of a
 * refresh: 54 fps at 60 Hz.
 */
export const missedVsync = {
  id: 'missed-vsync',
  label: 'Missed vsync',
  about:
    'Most frames take one refresh of the display; some two or three, in bursts: 54 fps at 60 Hz.',
  options,
  frames: ({ fps }: Values<typeof options>, duration: number) => 0.9 * fps * duration,
  start: (chosen: Values<typeof options>): Frames => new MissedVsyncFrames(chosen),
} as const satisfies FrameClock

class MissedVsyncFrames implements Frames {
  duration = NaN
  time = 0
  private refreshes = 0
  private busy = false
  private readonly fps: number
  private readonly random: Random

  constructor({ fps, seed }: Values<typeof options>) {
    this.fps = fps
    this.random = new Random(seed)
  }

  next(): void {
    const draw = this.random.next()
    // The highest bits decide whether the game changes, the lowest two how many refreshes a busy frame takes.
    this.busy = this.busy ? draw >>> 30 !== 0 : draw >>> 27 === 0
    const refreshes = this.busy ? 1 + (draw & 1) + ((draw >>> 1) & 1) : 1
    this.refreshes += refreshes
    this.duration = refreshes / this.fps
    this.time = this.refreshes / this.fps
  }
}
