import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const rapier: Engine = {
  id: 'rapier',
  label: 'Rapier',
  method: {
    timestep: { kind: 'per-frame', step: 1 / 60 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'A call of step moves the world by 1/60 s unless you set dt: called once a frame, it goes as fast as the frames.',
  leavesOut:
    'Left out: each step moves bodies in 4 parts, so that the error of gravity is a quarter of what is shown here; damping by 1/(1 + k Δt).',
  safer: ownLoop('call world.step()'),
  source: 'Rapier as read in November 2026, integration_parameters.rs and worker.rs',
}
