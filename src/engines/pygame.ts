import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const pygame: Engine = {
  id: 'pygame',
  label: 'Pygame and p5.js',
  method: {
    timestep: { kind: 'per-frame', step: 1 / 60 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Tutorials take a step every frame and aim at 60 fps: speed goes with the frame rate.',
  leavesOut:
    'Left out: code that multiplies by the time of a frame, which both can tell. Method and stops are yours; here they are those of the paper, clamped.',
  safer: ownLoop('move your game'),
  source: 'Tutorials of both, and p5.js main.js, as read in November 2026',
}
