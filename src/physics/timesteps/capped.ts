import { ExactSum } from '../exactSum.ts'
import type { Values } from '../options.ts'
import type { TimestepPolicy } from '../timestepPolicy.ts'
import { cap } from './options.ts'

const options = { cap } as const

/** A step a frame, but never a long one: slow machines play in slow motion. */
export const capped = {
  id: 'capped',
  label: 'Capped',
  about: 'One step a frame, never longer than the cap: the rest of a slow frame is lost.',
  options,
  losesTime: true,
  steps: (_, __, frames) => frames,
  start: ({ cap }: Values<typeof options>) => {
    const lost = new ExactSum()
    return (frame) => {
      if (frame.frameDuration > cap) lost.add(frame.frameDuration - cap)
      frame.motion.dt = Math.min(frame.frameDuration, cap)
      frame.step()
      frame.lostTime = lost.value
      frame.stateTime = frame.gameTime - frame.lostTime
    }
  },
} as const satisfies TimestepPolicy
