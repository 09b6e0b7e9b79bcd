import { createRun, integrators, simulate } from '../../physics/index.ts'
import type { Experiment, IntegratorId } from '../../physics/index.ts'
import {
  counts,
  evaluationsPerSecond,
  orderOfCurve,
  outcomeKinds,
  scaleOf,
  presentationErrorSizes,
} from '../../measure/index.ts'
import type { SweepCurve } from '../../measure/index.ts'
import type { WorkCurve } from '../schema/index.ts'
import { median, timeRounds } from '../timing/rounds.ts'
import type { Care, TimedWork } from '../timing/rounds.ts'
import type { FrontierProblem } from './problems.ts'

/**
 * Steps a second: from as few as a method of high order can do with to far beyond any screen, about half as many again
 * each.
 */
export const rates: readonly number[] = Array.from({ length: 13 }, (_, i) => 2 ** i).flatMap(
  (power) => [2 * power, 3 * power],
)

/** The error is looked at in frames, of one step each up to here and of 2, 4, 8 … beyond. */
const MOST_FRAMES = 1000

/** A method of ours at all step lengths. Time is taken of the steps alone, a second's worth at a time. */
export function ourCurve(
  problem: FrontierProblem,
  integrator: IntegratorId,
  care: Care,
): WorkCurve {
  const curve = swept(problem, integrator)
  const times = timeRounds(
    rates.map((rate) => stepping(problem, integrator, rate)),
    care,
  )
  const { label, colour } = integrators.find(({ id }) => id === integrator)!
  const order = orderOfCurve(curve)
  return {
    id: integrator,
    label,
    stopping: 'located',
    colour,
    order: Number.isFinite(order) ? order : null,
    points: rates.flatMap((rate, i) =>
      counts(curve, i)
        ? {
            setting: 1 / rate,
            error: curve.errors[i]!,
            evaluations: curve.evaluations[i]!,
            time: median(times[i]!),
          }
        : [],
    ),
  }
}

/** The run behind a point. */
export function rated(
  { experiment }: FrontierProblem,
  integrator: IntegratorId,
  rate: number,
): Experiment {
  let fps = rate
  while (fps > MOST_FRAMES) fps /= 2
  return {
    ...experiment,
    integrator,
    timestep: { kind: 'substeps', step: 1 / rate },
    frames: { kind: 'steady', fps },
  }
}

function swept(problem: FrontierProblem, method: IntegratorId): SweepCurve {
  const runs = rates.map((rate) => simulate(rated(problem, method, rate)))
  const sizes = runs.map(presentationErrorSizes)
  return {
    ...{ method, by: 'rate', settings: rates },
    errors: Float64Array.from(sizes, ({ largest }) => largest),
    rms: Float64Array.from(sizes, ({ rms }) => rms),
    evaluations: Float64Array.from(runs, evaluationsPerSecond),
    outcomes: Uint8Array.from(runs, ({ outcome }) => outcomeKinds.indexOf(outcome.kind)),
    scale: scaleOf(runs[0]!.experiment).length,
  }
}

function stepping(
  { experiment }: FrontierProblem,
  integrator: IntegratorId,
  rate: number,
): TimedWork {
  const { duration } = experiment
  const stepped = {
    ...experiment,
    integrator,
    timestep: { kind: 'substeps', step: 1 / rate },
  } as const
  // Enough runs at once that no clock is too coarse.
  const many = Math.ceil(20000 / (rate * duration))
  const start = () => Array.from({ length: many }, () => createRun(stepped))
  let runs = start()
  return {
    units: many * duration,
    prepare: () => {
      runs = start()
    },
    run: () => {
      let sum = 0
      for (const run of runs) {
        for (let second = 0; second < duration; second++) run.frame(1)
        sum += run.motion.s
      }
      return sum
    },
  }
}
