import type * as physicsModule from '../../physics/index.ts'
import type { IntegratorId } from '../../physics/index.ts'
import { inFrames } from '../bare/index.ts'
import type { Trial } from '../bare/index.ts'
import type { Work } from '../timing/rounds.ts'

/** The physics module of a checkout. */
export type Physics = typeof physicsModule

/** Runs that are made before the clock starts, so that their setup is not counted. */
const RUNS = 5

/** One call of `run.frame` a step. */
export function framing(physics: Physics, trial: Trial, integrator: IntegratorId): Work {
  const { steps, fps } = trial
  const experiment = inFrames(trial, integrator)
  const start = () => Array.from({ length: RUNS }, () => physics.createRun(experiment))
  let runs = start()
  return {
    units: RUNS * steps,
    prepare: () => {
      runs = start()
    },
    run: () => {
      let sum = 0
      for (const run of runs) {
        for (let n = 0; n < steps; n++) run.frame(1 / fps)
        sum += run.motion.s + run.motion.v
      }
      return sum
    },
  }
}

/** `simulate` of a whole trial, a step a frame. */
export function simulating(physics: Physics, trial: Trial, integrator: IntegratorId): Work {
  const experiment = inFrames(trial, integrator)
  return {
    units: trial.steps,
    run: () => {
      const { s } = physics.simulate(experiment)
      return s[s.length - 1]!
    },
  }
}
