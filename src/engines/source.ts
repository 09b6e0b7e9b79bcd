import type { Engine } from './engine.ts'

export const source: Engine = {
  id: 'source',
  label: 'Source, player',
  method: {
    timestep: {
      kind: 'fixed',
      step: 0.015,
      draw: 'interpolated',
    },
    integrator: 'velocity-verlet',
    stopping: 'clamped',
  },
  does: 'Ticks of 15 ms, half of gravity before the move and half after, drawn between two ticks.',
  leavesOut:
    'Left out: bounds on the ticks of a frame, of which no source was read; remote entities are drawn 0.1 s late.',
  safer: {
    how: 'Nothing: a tick is 15 ms on every machine, and no frame loses time.',
    timestep: { kind: 'fixed', step: 0.015, draw: 'interpolated' },
  },
  source: 'Source SDK 2013, gamemovement.cpp',
}
