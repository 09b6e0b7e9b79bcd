import { Solver } from 'odex'
import { exactMotion } from '../../physics/index.ts'
import type { WorkCurve, WorkPoint } from '../schema/index.ts'
import { median, timeRounds } from '../timing/rounds.ts'
import type { Care, TimedWork } from '../timing/rounds.ts'
import type { FrontierProblem } from './problems.ts'

const CONVERGED = 0

/** Three to each power of ten. */
export const tolerances: readonly number[] = Array.from(
  { length: 34 },
  (_, i) => 10 ** (-1 - i / 3),
)

/** odex at all tolerances, and for which of them it gave up. */
export function odexCurve(
  problem: FrontierProblem,
  care: Care,
): { curve: WorkCurve; failed: number[] } {
  const tries = tolerances.map((tolerance) => ({ tolerance, ...accuracy(problem, tolerance) }))
  const whole = tries.filter(({ converged }) => converged)
  const times = timeRounds(
    whole.map(({ tolerance }) => solving(problem, tolerance)),
    care,
  )
  const points = whole.map(({ tolerance, error, evaluations }, i): WorkPoint => ({
    setting: tolerance,
    error,
    evaluations,
    time: median(times[i]!),
  }))
  return {
    curve: { id: 'odex', label: 'odex', stopping: null, colour: null, order: null, points },
    failed: tries.filter(({ converged }) => !converged).map(({ tolerance }) => tolerance),
  }
}

/** The largest error at the ends of its own steps [m], and evaluations for a simulated second. */
export function accuracy(
  { experiment, acceleration }: FrontierProblem,
  tolerance: number,
): { error: number; evaluations: number; converged: boolean } {
  const { parameters, duration } = experiment
  const a = acceleration(parameters)
  const truth = exactMotion(experiment)
  const state = { s: 0, v: 0 }
  let evaluations = 0
  let error = 0
  const { outcome } = solver(tolerance).solve(
    (_, y) => {
      evaluations++
      return [y[1]!, a(y[0]!, y[1]!)]
    },
    0,
    [parameters.position!, parameters.speed!],
    duration,
    (_, __, t, y) => {
      error = Math.max(error, Math.abs(y[0]! - truth(t, state).s))
    },
  )
  return { error, evaluations: evaluations / duration, converged: outcome === CONVERGED }
}

function solving({ experiment, acceleration }: FrontierProblem, tolerance: number): TimedWork {
  const { parameters, duration } = experiment
  const a = acceleration(parameters)
  const odex = solver(tolerance)
  const f = (_: number, y: number[]) => [y[1]!, a(y[0]!, y[1]!)]
  const start = [parameters.position!, parameters.speed!]
  return { units: duration, run: () => odex.solve(f, 0, start, duration).y[0]! }
}

function solver(tolerance: number): Solver {
  const made = new Solver(2)
  made.relativeTolerance = tolerance
  made.absoluteTolerance = tolerance
  return made
}
