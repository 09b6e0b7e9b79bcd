import { integrators, parseExperiment, simulate } from '../physics/index.ts'
import type { Experiment, Integrator, IntegratorId, Outcome } from '../physics/index.ts'
import { presentationErrorSizes } from './error.ts'
import { fittedOrder } from './order.ts'
import { scaleOf, withoutRounding } from './rounding.ts'
import { evaluationsPerSecond, nanosecondsPerSecond, tickOf } from './work.ts'
import type { Clock } from './work.ts'

/** What is swept: methods × step lengths and tolerances, everything else as in the experiment. */
export interface SweepRequest {
  /** Its integrator, timestep and frames say nothing: the sweep's do. */
  readonly experiment: Experiment
  readonly methods: readonly IntegratorId[]
  /** Steps a second. */
  readonly rates: readonly number[]
  /** Errors allowed in each second of motion, from large to small [m/s]. */
  readonly tolerances: readonly number[]
}

/** The points of one curve: a method, in steps of some lengths or to some tolerances. */
export interface Settings {
  readonly method: IntegratorId
  readonly by: 'rate' | 'tolerance'
  /** Steps a second, or tolerances [m/s]. */
  readonly settings: readonly number[]
}

/** What a method did, a number for each of its settings. */
export interface SweepCurve extends Settings {
  /** The largest error of the run [m]. */
  readonly errors: Float64Array
  /** The root mean square of its errors [m], which orders are fitted to. */
  readonly rms: Float64Array
  /** Evaluations of the acceleration for a simulated second. */
  readonly evaluations: Float64Array
  /** How each run ended, as a place in `outcomeKinds`. */
  readonly outcomes: Uint8Array
  /** The length of the path, against which rounding is measured [m]. */
  readonly scale: number
}

/** How long a simulated second takes with a method, numbers for each of its settings [ns]. */
export interface TimedCurve extends Settings {
  /** The least of the rounds so far: what the work takes undisturbed. */
  readonly nanoseconds: Float64Array
  /** The most of them. */
  readonly slowest: Float64Array
}

export const outcomeKinds: readonly Outcome['kind'][] = [
  'moving',
  'at-rest',
  'left-the-track',
  'diverged',
]

/** From a slide show to what no screen shows, about evenly on a logarithmic scale [steps/s]. */
export const sweepRates: readonly number[] = [
  ...[5, 7.5, 10, 15, 20, 30, 45, 60, 90, 120, 180, 240, 360, 480, 720, 960],
]

/** From a millimetre a second to a tenth of a nanometre, a power of ten each. */
export const sweepTolerances: readonly number[] = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10]

/**
 * Frames for the runs to tolerance: as long as the longest step of the sweep, since a step is no longer than its frame
 * [fps].
 */
const TOLERANT_FPS = 5

/** Tolerances for which a method of order p takes some 1/this steps a second are the smallest that it is asked for [s]. */
const SHORTEST = 1e-4

/** All methods there are. */
export const sweepMethods: readonly IntegratorId[] = integrators.map(({ id }) => id)

/** How often the time of each point is taken: the least of them counts. */
export const TIMED_ROUNDS = 6

/** A clock that ticks more seldom is not worth waiting for [ms]: a sweep would take a quarter of an hour. */
const COARSEST_TICK = 2

/** An order is fitted to the finest so many points above rounding, and to no fewer than three. */
const FITTED = 6

/** The run behind a point: a step a frame, so that the lab shows the very same. */
export function sweptExperiment(
  { experiment }: Pick<SweepRequest, 'experiment'>,
  integrator: IntegratorId,
  rate: number,
): Experiment {
  const frames = { kind: 'steady', fps: rate } as const
  return { ...experiment, integrator, timestep: { kind: 'variable' }, frames }
}

/** The run behind a point of a curve by tolerance. */
export function tolerantExperiment(
  { experiment }: Pick<SweepRequest, 'experiment'>,
  integrator: IntegratorId,
  tolerance: number,
): Experiment {
  const frames = { kind: 'steady', fps: TOLERANT_FPS } as const
  return { ...experiment, integrator, timestep: { kind: 'tolerance', tolerance }, frames }
}

function experimentAt(request: SweepRequest, { method, by }: Settings, setting: number) {
  return (by === 'rate' ? sweptExperiment : tolerantExperiment)(request, method, setting)
}

/** The curves of a sweep: all by rate and, for tolerances that a method of its order can reach, all by tolerance. */
export function curvesOf({ methods, rates, tolerances }: SweepRequest): Settings[] {
  const byTolerance = methods.map((method) => {
    const { order, orderWithSpeed }: Integrator = integrators.find(({ id }) => id === method)!
    const least = SHORTEST ** Math.min(order, orderWithSpeed)
    // A power of ten is rounded, and so is this.
    const settings = tolerances.filter((tolerance) => tolerance >= 0.99 * least)
    return { method, by: 'tolerance', settings } as const
  })
  return [
    ...methods.map((method) => ({ method, by: 'rate', settings: rates }) as const),
    ...byTolerance.filter(({ settings }) => settings.length > 0),
  ]
}

/**
 * Runs the sweep, curve by curve. Between two points it yields nothing, so that whoever drives it can stop.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function* sweep(request: SweepRequest): Generator<SweepCurve | undefined> {
  const scale = scaleOf(parseExperiment(request.experiment)).length
  for (const curve of curvesOf(request)) {
    const { settings } = curve
    const column = () => new Float64Array(settings.length)
    const found = { errors: column(), rms: column(), evaluations: column() }
    const outcomes = new Uint8Array(settings.length)
    for (const [i, setting] of settings.entries()) {
      const run = simulate(experimentAt(request, curve, setting))
      const { largest, rms } = presentationErrorSizes(run)
      found.errors[i] = largest
      found.rms[i] = rms
      found.evaluations[i] = evaluationsPerSecond(run)
      outcomes[i] = outcomeKinds.indexOf(run.outcome.kind)
      yield i === settings.length - 1 ? { ...curve, ...found, outcomes, scale } : undefined
    }
  }
}

/**
 * Takes the time of each point of a sweep, curve by curve, and all of it again: what disturbs one round does not
 * disturb the next in the same place. It yields as `sweep` does, each curve as often as there are rounds.
 *
 * @throws ExperimentError for an experiment that can't be run, RangeError where the clock is too coarse
 */
export function* timedSweep(
  request: SweepRequest,
  clock: Clock,
): Generator<TimedCurve | undefined> {
  const curves = curvesOf(request)
  const tick = tickOf(clock)
  if (tick > COARSEST_TICK) throw new RangeError(coarseClock(tick))
  const columns = (value: number) =>
    curves.map(({ settings }) => new Float64Array(settings.length).fill(value))
  const least = columns(Infinity)
  const most = columns(0)
  for (let round = 0; round < TIMED_ROUNDS; round++)
    for (const [c, curve] of curves.entries()) {
      const nanoseconds = least[c]!
      const slowest = most[c]!
      const { settings } = curve
      for (const [i, setting] of settings.entries()) {
        const experiment = experimentAt(request, curve, setting)
        const taken = nanosecondsPerSecond(experiment, clock, tick)
        nanoseconds[i] = Math.min(nanoseconds[i]!, taken)
        slowest[i] = Math.max(slowest[i]!, taken)
        yield i === settings.length - 1
          ? { ...curve, nanoseconds: nanoseconds.slice(), slowest: slowest.slice() }
          : undefined
      }
    }
}

function coarseClock(tick: number): string {
  const how = Number.isFinite(tick) ? `ticks only every ${tick.toFixed(1)}\u202fms` : 'stands'
  return `This browser’s clock ${how}, too coarse to time a run. Evaluations are shown instead.`
}

/** A point stands for a whole run: one that left the track or blew up, or has no truth to be held to, does not count. */
export function counts({ errors, outcomes }: SweepCurve, i: number): boolean {
  const kind = outcomeKinds[outcomes[i]!]!
  return (kind === 'moving' || kind === 'at-rest') && Number.isFinite(errors[i]!)
}

/** Every run that counts is exact to rounding. */
export function isExact(curve: SweepCurve): boolean {
  const counting = Array.from(curve.errors).filter((_, i) => counts(curve, i))
  return counting.length > 0 && counting.every((error) => withoutRounding(error, curve.scale) === 0)
}

/**
 * The order that a curve by rate shows: fitted to the root mean square errors of its finest steps that are still
 * well above rounding. NaN where fewer than three are left.
 */
export function orderOfCurve(curve: SweepCurve): number {
  const fine = curve.settings
    .map((rate, i) => ({ step: 1 / rate, error: curve.rms[i]!, whole: counts(curve, i) }))
    .filter(({ error, whole }) => whole && withoutRounding(error / 10, curve.scale) > 0)
    .sort((a, b) => a.step - b.step)
    .slice(0, FITTED)
  if (fine.length < 3) return NaN
  return fittedOrder(
    fine.map(({ step }) => step),
    fine.map(({ error }) => error),
  )
}
