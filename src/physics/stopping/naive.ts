import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'
import { settle } from '../settle.ts'
import type { StoppingRule } from '../stoppingRule.ts'
import { stayOnTrack } from './track.ts'

/** The paper's formula as it stands: friction against the sign of v, whenever it is asked for. */
export const naive = {
  id: 'naive',
  label: 'Naive',
  about:
    'Friction points against the velocity and nothing else is done: around v = 0 it pushes to and fro for ever.',
  keepsOrder: false,
  holdsSlip: false,
  advance(motion: Motion, integrator: Integrator): void {
    motion.elapsed = 0
    motion.begin()
    integrator.step(motion)
    motion.elapsed = motion.dt
    settle(motion)
    stayOnTrack(motion)
  },
} as const satisfies StoppingRule
