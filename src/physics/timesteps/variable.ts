import type { TimestepPolicy } from '../timestepPolicy.ts'

/** The paper's: the step is the frame. */
export const variable = {
  id: 'variable',
  label: 'Variable',
  about: 'One step a frame, as long as the frame was: multiply by deltaTime, as the paper does.',
  options: {},
  losesTime: false,
  stepIsFrame: true,
  steps: (_, __, frames) => frames,
  // #region advance
  start: () => (run) => {
    run.motion.dt = run.frameDuration
    run.step()
    run.stateTime = run.time
  },
  // #endregion
} as const satisfies TimestepPolicy
