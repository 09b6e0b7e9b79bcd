import { integrators, parseExperiment, simulate } from '../physics/index.ts'
import type { Experiment, Integrator, IntegratorId, Outcome } from '../physics/index.ts'
import { presentationErrorSizes } from './error.ts'
import { fittedOrder } from './order.ts'
import { scaleOf, withoutRounding } from './rounding.ts'
import { evaluationsPerSecond, nanosecondsPerSecond, tickOf } from './work.ts'
import type { Clock } from './work.ts'

/** What is swept: methods × step lengths and tolerances, everything else as in the experiment. */
export interface SweepRequest {
  /** Its integrator, timestep and frames are ignored: the sweep sets them. */
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

/** The results of a method, one for each of its settings. */
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
  /** The shortest time of the rounds so far: the one that other programs disturbed least. */
  readonly nanoseconds: Float64Array
  /** The longest time of the rounds so far. */
  readonly slowest: Float64Array
}

export const outcomeKinds: readonly Outcome['kind'][] = [
  'moving',
  'at-rest',
  'left-the-track',
  'diverged',
]

/** From far below to far above any screen's rate, about evenly on a logarithmic scale [steps/s]. */
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

/** The shortest typical step of a run to a tolerance: a method gets no smaller tolerance than one that needs it [s]. */
const SHORTEST = 1e-4

/** All integrators. */
export const sweepMethods: readonly IntegratorId[] = integrators.map(({ id }) => id)

/** The number of timings of each point; the shortest counts. */
export const TIMED_ROUNDS = 6

/** The coarsest usable clock tick [ms]: with a longer one, a sweep would take a quarter of an hour. */
const COARSEST_TICK = 2

/** An order is fitted to the finest so many points above rounding, and to no fewer than three. */
const FITTED = 6

/** The run of a point: one step a frame, so that the lab can show exactly the same run. */
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
    // Powers of ten are rounded, and so is this limit.
    const settings = tolerances.filter((tolerance) => tolerance >= 0.99 * least)
    return { method, by: 'tolerance', settings } as const
  })
  return [
    ...methods.map((method) => ({ method, by: 'rate', settings: rates }) as const),
    ...byTolerance.filter(({ settings }) => settings.length > 0),
  ]
}

/**
 * Runs the sweep, curve by curve. It yields undefined between two points, so that the caller can stop.
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
 * Times each point of a sweep, curve by curve, in several rounds: a disturbance in one round does not
 * hit the same point in the next. It yields like `sweep`, each curve once a round.
 *
 * @throws ExperimentError for an experiment that can't be run, RangeError where the clock is too coarse
 */
export function* timedSweep(
  request: SweepRequest,
  clock: Clock,
): Generator<TimedCurve | undefined> {
  const tick = tickOf(clock)
  if (tick > COARSEST_TICK) throw new RangeError(coarseClock(tick))
  const curves = curvesOf(request)
  const column = (value: number) =>
    curves.map(({ settings }) => new Float64Array(settings.length).fill(value))
  const least = column(Infinity)
  const most = column(0)
  for (let round = 0; round < TIMED_ROUNDS; round++)
    for (const [c, curve] of curves.entries()) {
      const nanoseconds = least[c]!
      const slowest = most[c]!
      const { settings } = curve
      for (const [i, setting] of settings.entries()) {
        const taken = nanosecondsPerSecond(experimentAt(request, curve, setting), clock, tick)
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

/** Whether a point counts: not if its run left the track or blew up, or if the true motion is not known. */
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
