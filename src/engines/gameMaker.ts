import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const gameMaker: Engine = {
  id: 'game-maker',
  label: 'GameMaker',
  method: {
    timestep: { kind: 'per-frame', step: 1 / 60 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Every frame is a step, 60 a second by default: slow frames are slow motion.',
  leavesOut:
    'Left out: its friction takes a fixed speed a step and stops at 0, and gravity comes after it.',
  safer: ownLoop('move your instances'),
  source: 'GameMaker-HTML5 as read in November 2026, yyInstance.js and yyPhysicsWorld.js',
}
