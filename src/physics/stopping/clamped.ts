import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'
import { settle } from '../settle.ts'
import type { StoppingRule } from '../stoppingRule.ts'
import { setsOff } from './staticFriction.ts'
import { stayOnTrack } from './track.ts'

/** A step that would reverse the sliding ends at rest instead; the next decides whether the block stays. */
export const clamped = {
  id: 'clamped',
  label: 'Clamped',
  about:
    'A step that would turn the velocity round ends with v = 0 instead: what games do. At rest, but up to a frame too late.',
  keepsOrder: false,
  holdsSlip: true,
  // #region advance
  advance(motion: Motion, integrator: Integrator): void {
    motion.elapsed = 0
    if (motion.v === 0 && !setsOff(motion)) return
    const { slip, law } = motion
    motion.begin()
    integrator.step(motion)
    if (law.muStatic > 0 && (slip > 0 ? motion.v < 0 : motion.v > 0)) {
      motion.v = 0
      // Friction brings a block to a stop; it does not push it back beyond where the step began.
      if (slip > 0 ? motion.s < motion.startS : motion.s > motion.startS) motion.s = motion.startS
      motion.known = 0
    }
    motion.elapsed = motion.dt
    settle(motion)
    stayOnTrack(motion)
  },
  // #endregion
} as const satisfies StoppingRule
