import { ownLoop } from './engine.ts'
import type { Engine } from './engine.ts'

export const matter: Engine = {
  id: 'matter',
  label: 'Matter.js, Runner',
  method: {
    timestep: { kind: 'fixed', step: 1 / 60, maxSteps: 2, cap: 1 / 15, draw: 'latest' },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
  },
  does: 'Steps of 1/60 s, at most 2 in a frame; the last one is drawn. Frames of more than 1/15 s don’t count in full.',
  leavesOut:
    'Left out: such a frame is replaced by the one before, delta is a mean of 100 snapped to whole hertz, a step waits for 1.5 steps of debt, air takes 1 % of the speed a step, and its friction is not Coulomb’s.',
  safer: ownLoop('call Engine.update(engine, 1000 / 60)'),
  source: 'Matter.js 0.20, Runner.js and Body.js',
}
