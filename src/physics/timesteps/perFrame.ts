import type { Values } from '../options.ts'
import type { TimestepPolicy } from '../timestepPolicy.ts'
import { step } from './options.ts'

const options = { step } as const

/** The classic bug: a step for every frame, whatever the frame's length. */
export const perFrame = {
  id: 'per-frame',
  label: 'No delta time',
  about: 'One step of the same length every frame: the faster the machine, the faster the game.',
  options,
  losesTime: true,
  steps: (_, __, frames) => frames,
  start: (chosen: Values<typeof options>) => {
    let steps = 0
    return (frame) => {
      // Such a game knows no frame times: in slow motion it takes shorter steps.
      const step = frame.timeScale * chosen.step
      // #region advance
      frame.motion.dt = step
      frame.step()
      // #endregion
      frame.stateTime = ++steps * step
    }
  },
} as const satisfies TimestepPolicy
