import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const planck: Engine = {
  id: 'planck',
  label: 'Planck, testbed',
  method: {
    timestep: { kind: 'fixed', step: 1 / 60, maxSteps: 2, cap: 1 / 30, draw: 'latest' },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Steps of 1/60 s. A frame counts for 1/30 s at most, which is two steps; the rest is dropped.',
  leavesOut: 'Left out: damping by 1/(1 + k Δt), which is 0 unless you set it.',
  safer: ownLoop('call world.step(1 / 60)'),
  source: 'Planck 1.4.3, StageTestbed.ts and Solver.ts',
}
