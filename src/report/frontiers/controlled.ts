import { integrators, simulate } from '../../physics/index.ts'
import type { Experiment, IntegratorId } from '../../physics/index.ts'
import { evaluationsPerSecond, presentationErrorSizes } from '../../measure/index.ts'
import type { Controlled } from '../schema/index.ts'
import { costAt } from './compare.ts'
import { accuracy, tolerances as odexTolerances } from './odex.ts'
import { problems } from './problems.ts'
import type { FrontierProblem } from './problems.ts'

/** Errors at which odex and ours to tolerance are compared [m]. */
const errors: readonly number[] = [1e-4, 1e-6, 1e-8, 1e-10]

/** Three to each power of ten [m/s]. */
const tolerances: readonly number[] = Array.from({ length: 25 }, (_, i) => 10 ** (-3 - i / 3))

const methods: readonly IntegratorId[] = ['velocity-verlet', 'rk4', 'rk8']

/** Verlet takes the square root of the error in steps: below this it takes seconds for a point [m/s]. */
const LEAST_FOR_VERLET = 1e-8

/** The run to a tolerance: in long frames, since a step is never longer than its frame. */
export function controlledRun(
  { experiment }: FrontierProblem,
  integrator: IntegratorId,
  tolerance: number,
): Experiment {
  return {
    ...experiment,
    integrator,
    timestep: { kind: 'tolerance', tolerance },
    frames: { kind: 'steady', fps: 2 },
  }
}

/**
 * What methods that choose their own steps spend on an error: odex, and ours to tolerance, tries and doubled steps included. These
 * are evaluations, which are counted and not timed: the same on every machine.
 */
export function controlled(): Controlled[] {
  return problems.map((problem) => {
    const own = methods.map((method) => ({
      label: integrators.find(({ id }) => id === method)!.label,
      points: tolerances
        .filter((tolerance) => method !== 'velocity-verlet' || tolerance >= LEAST_FOR_VERLET)
        .map((tolerance) => {
          const run = simulate(controlledRun(problem, method, tolerance))
          const error = presentationErrorSizes(run).largest
          return { error, evaluations: evaluationsPerSecond(run) }
        }),
    }))
    const odex = odexTolerances
      .map((tolerance) => accuracy(problem, tolerance))
      .filter(({ converged }) => converged)
    return {
      id: problem.id,
      label: problem.label,
      about: problem.about,
      at: errors.map((error) => {
        const offers = own.flatMap(({ label, points }) => {
          const evaluations = costAt(points, error, 'evaluations')
          return evaluations === null ? [] : [{ label, evaluations }]
        })
        offers.sort((a, b) => a.evaluations - b.evaluations)
        return { error, ours: offers[0] ?? null, odex: costAt(odex, error, 'evaluations') }
      }),
    }
  })
}
