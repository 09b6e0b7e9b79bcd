import {
  createRun,
  integrators,
  scenes,
  simulate,
  stoppings,
  timesteps,
} from '../../physics/index.ts'
import type { Described, Experiment, Options, Timestep } from '../../physics/index.ts'
import type { TimedWork } from './rounds.ts'

// `bench --against` bundles this file with the physics of each checkout, so that no call site sees two of them.

/** Runs of so many steps of `step` seconds, `runs` of them at once; they are made before the clock starts. */
export interface Amount {
  readonly runs: number
  readonly steps: number
  readonly step: number
}

/** One call of `run.frame` a step. */
export function framing(experiment: Experiment, { runs, steps, step }: Amount): TimedWork {
  const start = () => Array.from({ length: runs }, () => createRun(experiment))
  let started = start()
  return {
    units: runs * steps,
    prepare: () => {
      started = start()
    },
    run: () => {
      let sum = 0
      for (const run of started) {
        for (let n = 0; n < steps; n++) run.frame(step)
        sum += run.motion.s + run.motion.v + run.heat
      }
      return sum
    },
  }
}

/** One call of `simulate`, which records every frame. */
export function simulating(experiment: Experiment, frames: number): TimedWork {
  return {
    units: frames,
    run: () => {
      const { s } = simulate(experiment)
      return s[s.length - 1]!
    },
  }
}

/** Runs all scenes, methods, rules and policies, so that the call sites of this process have seen them. */
export function runEverything(): void {
  for (let round = 0; round < 3; round++)
    for (const { id: scene } of scenes)
      for (const { id: integrator, order } of integrators)
        for (const { id: stopping } of stoppings)
          for (const timestep of timesteps) {
            // A method of first order takes millions of steps to a tolerance, and goes by the same call sites as others.
            if (timestep.id === 'tolerance' && order === 1) continue
            const experiment = { scene, integrator, stopping, timestep: initially(timestep) }
            simulate({ ...experiment, duration: 1 })
            const run = createRun(experiment)
            for (let frame = 0; frame < 60; frame++) run.frame(1 / 60)
          }
}

/** A policy with its options as the lab has them at first. */
function initially({ id, options }: Described & { options: Options }): Timestep {
  const values = Object.entries(options).map(([key, option]) => [key, option.initial])
  return { kind: id, ...Object.fromEntries(values) } as Timestep
}
