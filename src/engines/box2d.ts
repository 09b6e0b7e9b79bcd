import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const box2d: Engine = {
  id: 'box2d',
  label: 'Box2D, samples',
  method: {
    timestep: { kind: 'per-frame', step: 1 / 60 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'A step of 1/60 s every frame, whatever its length: below 60 fps the samples run in slow motion.',
  leavesOut:
    'Left out: each step moves bodies in 4 parts of 1/240 s, so that the error of gravity is a quarter of what is shown here.',
  safer: ownLoop('call b2World_Step(world, 1.0f / 60.0f, 4)'),
  source: 'Box2D 3.1.1, sample.h, main.cpp and solver.c',
}
