import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const love: Engine = {
  id: 'love',
  label: 'LÖVE',
  method: {
    timestep: { kind: 'variable' },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'love.update gets the time of the last frame, however long: one step of it.',
  leavesOut:
    'Left out: nothing of the loop. Method and stops are yours; here they are those of the paper, clamped. Its physics damps by 1/(1 + k Δt).',
  safer: ownLoop('move your game'),
  source: 'LÖVE 11.5, callbacks.lua and b2Island.cpp',
}
