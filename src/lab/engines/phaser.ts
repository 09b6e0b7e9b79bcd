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
  source: 'Phaser 4.2.1, core/TimeStep.js and arcade/World.js',
}
