import type { Engine } from './engine.ts'

export const quake3: Engine = {
  id: 'quake-3',
  label: 'Quake III, player',
  method: {
    timestep: { kind: 'substeps', step: 0.066 },
    integrator: 'velocity-verlet',
    stopping: 'clamped',
  },
  does: 'Cuts a frame into parts of at most 66 ms; each moves by the mean of the speeds before and after.',
  leavesOut:
    'Left out: a part is 66 ms and the last one the rest, where here all are equal; and speeds are rounded to whole numbers, which is its famous jump.',
  safer: {
    how: 'Set pmove_fixed to 1: then the player moves in steps of pmove_msec, 8 ms, on every machine.',
    timestep: { kind: 'fixed', step: 0.008, draw: 'latest' },
  },
  source: 'Quake III as read in November 2026, bg_pmove.c and bg_slidemove.c',
}
