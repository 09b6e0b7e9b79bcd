import type { TimestepPolicy } from '../timestepPolicy.ts'

/** The paper's: the step is the frame. */
export const variable = {
  id: 'variable',
  label: 'Variable',
  about: 'One step a frame, as long as the frame: times deltaTime, as in the paper.',
  options: {},
  losesTime: false,
  steps: (_, __, frames) => frames,
  start: () => (frame) => {
    // #region advance
    frame.motion.dt = frame.frameDuration
    frame.step()
    // #endregion
    frame.stateTime = frame.gameTime
  },
} as const satisfies TimestepPolicy
