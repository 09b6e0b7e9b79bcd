import type { Engine } from './engine.ts'

export const pico8: Engine = {
  id: 'pico-8',
  label: 'PICO-8',
  method: {
    timestep: { kind: 'per-frame', step: 1 / 30 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Every call of _update is a step, 30 a second.',
  leavesOut:
    'Left out: _update60 makes it 60, and an overloaded cart updates twice for each picture. Method and stops are yours; here they are those of the paper, clamped.',
  source: 'PICO-8 manual as read in November 2026',
}
