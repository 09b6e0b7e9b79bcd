import type { StoppingRule } from '../stoppingRule.ts'

/** A step that would reverse the sliding ends at rest instead; the next decides whether the block stays. */
export const clamped = {
  id: 'clamped',
  label: 'Clamped',
  about:
    'A step that would turn the velocity round ends with v = 0: what games do. At rest, but up to a frame too late.',
  keepsOrder: false,
  holdsSlip: true,
  step: (motion, integrator) => {
    // #region step
    const { slip, startS, dt } = motion
    const { belt, muStatic } = motion.law
    integrator.step(motion)
    const reversed = slip > 0 ? motion.v < belt : motion.v > belt
    if (reversed && muStatic > 0) {
      motion.stop()
      // Friction brings a block to a stop; it does not push it back beyond where the track was as the step began.
      const start = startS + belt * dt
      motion.s = slip > 0 ? Math.max(motion.s, start) : Math.min(motion.s, start)
    }
    // #endregion
  },
} as const satisfies StoppingRule
