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
  safer: {
    how: 'On the console nothing: it calls _update 30 times a second on every machine. A port needs an accumulator of its own that pays for steps of 1/30 s.',
    timestep: { kind: 'fixed', step: 1 / 30, maxSteps: 30, draw: 'latest' },
  },
  source: 'PICO-8 manual as read in November 2026',
}
