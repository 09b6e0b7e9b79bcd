import type { Engine } from './engine.ts'

export const monoGame: Engine = {
  id: 'mono-game',
  label: 'MonoGame',
  method: {
    timestep: {
      kind: 'fixed',
      step: 1 / 60,
      cap: 0.5,
      draw: 'latest',
    },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Update runs 60 times a second (IsFixedTimeStep). A frame counts for 0.5 s at most (MaxElapsedTime); the rest is dropped.',
  leavesOut:
    'Left out: nothing of the loop. Method and stops are yours; here they are those of the paper, clamped.',
  safer: {
    how: 'Set TargetElapsedTime to 1/120 s, and MaxElapsedTime to 1 s as long as 120 steps take less time than that. Frames of up to a second then lose nothing, and the error is about half.',
    timestep: { kind: 'fixed', step: 1 / 120, cap: 1, draw: 'latest' },
  },
  source: 'MonoGame as read in November 2026, Game.cs',
}
