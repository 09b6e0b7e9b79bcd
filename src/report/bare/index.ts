import type { IntegratorId, SceneId } from '../../physics/index.ts'
import type { BareLoop, Loop } from './bareLoop.ts'
import * as fall from './fall.ts'
import * as halfPipe from './halfPipe.ts'
import * as ramp from './ramp.ts'
import * as runOut from './runOut.ts'
import * as spring from './spring.ts'
import { trials } from './trials.ts'

export { inFrames, inSeconds } from './bareLoop.ts'
export type { BareLoop, Trial } from './bareLoop.ts'

/** The loops of a file, which names them as the project names its methods. */
type Loops = Readonly<Record<keyof typeof fall, Loop>>

/** A method without loops is not in the benchmark. */
const methods: Readonly<Partial<Record<IntegratorId, keyof Loops>>> = {
  'explicit-euler': 'explicitEuler',
  'semi-implicit-euler': 'semiImplicitEuler',
  'velocity-verlet': 'velocityVerlet',
  midpoint: 'midpoint',
  rk4: 'rk4',
  yoshida4: 'yoshida4',
  'implicit-midpoint': 'implicitMidpoint',
}

function inScene(scene: SceneId, loops: Loops): BareLoop[] {
  return (Object.keys(methods) as IntegratorId[]).map((integrator) => {
    const end = loops[methods[integrator]!]
    return {
      scene,
      integrator,
      trials: trials.filter((trial) => trial.scene === scene),
      end,
      run: (given, dt, steps) => {
        const { s, v, heat } = end(given, dt, steps)
        return s + v + heat
      },
    }
  })
}

/** A hand-written loop for every scene and method, scene by scene in the order of the lists. */
export const bareLoops: readonly BareLoop[] = [
  ...inScene('fall', fall),
  ...inScene('ramp', ramp),
  ...inScene('run-out', runOut),
  ...inScene('half-pipe', halfPipe),
  ...inScene('spring', spring),
]
