import type { IntegratorId } from '../../physics/index.ts'
import type { TimedScene } from '../timing/trials.ts'
import type { TimedWork } from '../timing/rounds.ts'
import type { Amount } from '../timing/works.ts'
import type { HandwrittenBlock, Given } from './block.ts'
import { HalfPipeRk4 } from './halfPipeRk4.ts'
import { HalfPipeVerlet } from './halfPipeVerlet.ts'
import { RampRk4 } from './rampRk4.ts'
import { RampVerlet } from './rampVerlet.ts'
import { SpringRk4 } from './springRk4.ts'
import { SpringVerlet } from './springVerlet.ts'

export type { HandwrittenBlock } from './block.ts'

/** A scene and a method that have a handwritten loop. */
export interface Handwritten {
  readonly scene: TimedScene
  readonly integrator: IntegratorId
  readonly start: (given: Given) => HandwrittenBlock
}

/** What calls of `run.frame` are compared with. */
export const handwritten: readonly Handwritten[] = [
  {
    scene: 'ramp',
    integrator: 'velocity-verlet',
    start: (given) => new RampVerlet(given),
  },
  { scene: 'ramp', integrator: 'rk4', start: (given) => new RampRk4(given) },
  {
    scene: 'half-pipe',
    integrator: 'velocity-verlet',
    start: (given) => new HalfPipeVerlet(given),
  },
  { scene: 'half-pipe', integrator: 'rk4', start: (given) => new HalfPipeRk4(given) },
  {
    scene: 'spring',
    integrator: 'velocity-verlet',
    start: (given) => new SpringVerlet(given),
  },
  { scene: 'spring', integrator: 'rk4', start: (given) => new SpringRk4(given) },
]

/** Loops of so many frames of `step` seconds, `runs` of them at once. */
export function looping(start: () => HandwrittenBlock, { runs, steps, step }: Amount): TimedWork {
  const startAll = () => Array.from({ length: runs }, start)
  let blocks = startAll()
  return {
    units: runs * steps,
    prepare: () => {
      blocks = startAll()
    },
    run: () => {
      let sum = 0
      for (const block of blocks) {
        block.frames(steps, step)
        sum += block.s + block.v + block.heat
      }
      return sum
    },
  }
}
