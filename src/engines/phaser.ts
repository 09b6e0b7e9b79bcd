import type { Engine } from './engine.ts'

export const phaser: Engine = {
  id: 'phaser',
  label: 'Phaser, Arcade Physics',
  method: {
    timestep: {
      kind: 'fixed',
      step: 1 / 60,
      cap: 0.2,
      draw: 'latest',
    },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Steps of 1/60 s. A frame counts for 0.2 s at most, and the last step is drawn.',
  leavesOut:
    'Left out: delta is the mean of ten frames, one of more than 0.2 s is replaced by earlier ones, and after a start 120 frames count for at most 16.7 ms. Drag has rules of its own.',
  safer: {
    how: 'Set fps of Arcade Physics to 120, and fps.min of the game to 1 as long as 120 steps take less than a second. Frames of up to a second then lose nothing, and the error is about half.',
    timestep: { kind: 'fixed', step: 1 / 120, cap: 1, draw: 'latest' },
  },
  source: 'Phaser 4.2.1, core/TimeStep.js and arcade/World.js',
}
