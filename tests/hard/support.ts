import { hardCases } from '../../src/measure/index.ts'
import type { HardCase } from '../../src/measure/index.ts'
import { exactMotion, integrators } from '../../src/physics/index.ts'
import type { Experiment, Integrator, IntegratorId, Trajectory } from '../../src/physics/index.ts'

export type Method = Integrator & { readonly id: IntegratorId }

export const methods: readonly Method[] = integrators
export const secondOrder = methods.filter(({ order }) => order >= 2)
export const firstOrder = methods.filter(({ order }) => order === 1)

/** The case of that name; every one is named in some test, which `hardCases.test.ts` checks. */
export function hardCase(id: string): HardCase {
  const found = hardCases.find((each) => each.id === id)
  if (!found) throw new Error(`There is no hard case “${id}”.`)
  return found
}

export function last(values: Float64Array): number {
  return values[values.length - 1]!
}

/** The largest value in size. */
export function largest(values: Float64Array): number {
  return values.reduce((most, value) => Math.max(most, Math.abs(value)), 0)
}

/** The largest |s − exact(stateTime)| of a run [m]. */
export function largestError({ experiment, s, stateTime }: Trajectory): number {
  const truth = exactMotion(experiment)
  return largest(s.map((value, row) => value - truth(stateTime[row]!, { s: 0, v: 0 }).s))
}

/** An experiment with other parameters, the rest of them kept. */
export function having(experiment: Experiment, parameters: Experiment['parameters']): Experiment {
  return { ...experiment, parameters: { ...experiment.parameters, ...parameters } }
}
