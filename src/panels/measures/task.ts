import { parseExperiment, scenes } from '../../physics/index.ts'
import type { Scene } from '../../physics/index.ts'
// Not by the door of measure: the worker would carry the hard cases, which the page has already.
import { rateMap, rowsOf } from '../../measure/rateMap.ts'
import { spreadTable } from '../../measure/spreadTable.ts'
import { curvesOf, sweep, sweepMethods, TIMED_ROUNDS, timedSweep } from '../../measure/sweep.ts'
import type {
  Clock,
  MapRequest,
  MapRow,
  SpreadRequest,
  SpreadRow,
  SweepCurve,
  SweepRequest,
  TimedCurve,
} from '../../measure/index.ts'

/** Something to be measured, as plain JSON: what is sent to the worker. */
export type Task =
  | { readonly kind: 'sweep'; readonly request: SweepRequest }
  | { readonly kind: 'timing'; readonly request: SweepRequest }
  | { readonly kind: 'map'; readonly request: MapRequest }
  | { readonly kind: 'spreads'; readonly request: SpreadRequest }

/** A part of what was measured. */
export type Part = SweepCurve | TimedCurve | MapRow | SpreadRow

/** Measuring under way: where it yields nothing there is nothing to be told yet, but it can be stopped there. */
export interface TaskWork {
  readonly parts: Generator<Part | undefined>
  /** How often it yields. */
  readonly total: number
}

/** The most cells, points or numbers of a task. */
const MOST = 100_000

/**
 * Begins a task.
 *
 * @param value the task, of which nothing is known yet
 * @param clock tells the time [ms]
 * @throws ExperimentError for an experiment that can't be run, RangeError for anything else that is no task
 */
export function begin(value: unknown, clock: Clock): TaskWork {
  const { kind, request } = object(value, 'The task')
  const asked = object(request, 'The request')
  switch (kind) {
    case 'sweep':
    case 'timing': {
      const checked = sweepRequest(asked)
      const points = curvesOf(checked).reduce((sum, { settings }) => sum + settings.length, 0)
      return kind === 'sweep'
        ? { parts: sweep(checked), total: points }
        : { parts: timedSweep(checked, clock), total: TIMED_ROUNDS * points }
    }
    case 'map': {
      const checked = mapRequest(asked)
      return { parts: rateMap(checked), total: rowsOf(checked) }
    }
    case 'spreads': {
      const checked = spreadRequest(asked)
      const total = checked.methods.length * checked.experiments.length
      return { parts: spreadTable(checked), total }
    }
    default:
      throw new RangeError(`“${String(kind)}” is nothing that can be measured.`)
  }
}

function sweepRequest({
  experiment,
  methods,
  rates,
  tolerances,
}: Record<string, unknown>): SweepRequest {
  return {
    experiment: parseExperiment(experiment),
    methods: list(methods, 'methods').map((each) => {
      const known = sweepMethods.find((id) => id === each)
      if (!known) throw new RangeError(`“${String(each)}” is not one of the methods.`)
      return known
    }),
    rates: list(rates, 'rates').map((rate) => number(rate, 'A rate', 1, 1000)),
    tolerances: list(tolerances, 'tolerances').map((tolerance) =>
      number(tolerance, 'A tolerance', 1e-12, 1e-3),
    ),
  }
}

function mapRequest(asked: Record<string, unknown>): MapRequest {
  const experiment = parseExperiment(asked.experiment)
  const { parameters }: Scene = scenes.find(({ id }) => id === experiment.scene)!
  const parameter = String(asked.parameter)
  const option = Object.hasOwn(parameters, parameter) ? parameters[parameter] : undefined
  if (!option) throw new RangeError(`“${parameter}” is not a parameter of ${experiment.scene}.`)
  const { of } = asked
  if (of !== 'error' && of !== 'spread')
    throw new RangeError(`A map shows an error or a spread, not “${String(of)}”.`)
  return {
    experiment,
    of,
    parameter,
    from: number(asked.from, `${option.label}, from`, option.min, option.max),
    to: number(asked.to, `${option.label}, to`, option.min, option.max),
    slowest: number(asked.slowest, 'The slowest rate', 1, 1000),
    fastest: number(asked.fastest, 'The fastest rate', 1, 1000),
    columns: number(asked.columns, 'The columns', 1, 1000),
    rows: number(asked.rows, 'The rows', 1, 1000),
  }
}

function spreadRequest({ methods, experiments }: Record<string, unknown>): SpreadRequest {
  const parsed = list(experiments, 'experiments').map(parseExperiment)
  return {
    experiments: parsed,
    methods: list(methods, 'methods').map((each) => {
      const { integrator, stopping, timestep } = object(each, 'A method')
      const whole = parseExperiment({ scene: 'fall', integrator, stopping, timestep })
      return { integrator: whole.integrator, stopping: whole.stopping, timestep: whole.timestep }
    }),
  }
}

function object(value: unknown, what: string): Record<string, unknown> {
  if (typeof value !== 'object' || value === null)
    throw new RangeError(`${what} is not an object but ${String(value)}.`)
  return value as Record<string, unknown>
}

function list(value: unknown, what: string): unknown[] {
  if (!Array.isArray(value) || value.length < 1 || value.length > MOST)
    throw new RangeError(`The ${what} are not a list of 1 to ${MOST}.`)
  return value
}

function number(value: unknown, what: string, min: number, max: number): number {
  if (typeof value === 'number' && value >= min && value <= max) return value
  throw new RangeError(`${what}: ${String(value)} is not in ${min}…${max}.`)
}
