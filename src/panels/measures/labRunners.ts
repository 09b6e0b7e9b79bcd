import type { ResolvedExperiment, Trajectory } from '../../physics/index.ts'
import {
  evaluationsPerSecond,
  presentationErrorSizes,
  scaleOf,
  sweepRates,
  withoutRounding,
} from '../../measure/index.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'
import type { DiagramCurve, DiagramPoint } from './points.ts'

/** A runner of the lab: its point among the curves, or in a few words why it has none. */
export interface LabRunner {
  readonly name: string
  /** Place in the palette and the list of marks. */
  readonly paletteIndex: number
  readonly point: DiagramPoint | undefined
  readonly why: string
}

/** What all runs of the curves share. */
type Shared = Pick<ResolvedExperiment, 'stopping' | 'duration'>

/** A run's largest error is looked for once, however often it is drawn [m]. */
const errors = new WeakMap<Trajectory, number>()

/**
 * Where the runners of a lab stand in the diagram: error and cost are those of their own runs, taken as the curves’ are.
 * Where the cost is time, a runner's is that of the very same run among the curves', once it is measured; NaN until then.
 *
 * @param timed the curves, where their cost is time
 */
export function labRunners(
  runners: readonly SimulatedRunner[],
  shared: Shared,
  timed: readonly DiagramCurve[] | undefined,
): LabRunner[] {
  return runners.map(({ name, state: { paletteIndex }, trajectory }) => {
    const { integrator: method, stopping, timestep, frames } = trajectory.experiment
    const rate = frames.kind === 'steady' ? frames.fps : NaN
    const apart = stopping !== shared.stopping || timestep.kind !== 'variable'
    const isTimed = !apart && sweepRates.includes(rate)
    const why = whyNot(trajectory, shared) || (timed && !isTimed ? 'its time is not taken' : '')
    if (why) return { name, paletteIndex, why, point: undefined }
    const curve = timed?.find((each) => each.method === method && each.by === 'rate')
    const same = curve?.points.find((point) => point.setting === rate)
    const cost = timed ? (same?.cost ?? NaN) : evaluationsPerSecond(trajectory)
    const mostCost = same?.mostCost
    const largest = errors.get(trajectory) ?? presentationErrorSizes(trajectory).largest
    errors.set(trajectory, largest)
    const error = withoutRounding(largest, scaleOf(trajectory.experiment).length)
    const { kind: outcome } = trajectory.outcome
    const whole = (outcome === 'moving' || outcome === 'at-rest') && Number.isFinite(error)
    const runner = { name, paletteIndex, apart }
    const point = {
      ...{ method, by: 'rate' as const, setting: rate },
      ...{ cost, mostCost, error, outcome, whole, runner },
    }
    return { name, paletteIndex, why, point }
  })
}

/** Why a run can't be held against the curves, whose steps are all of one length and whose seconds are the clock’s. */
function whyNot({ experiment, lostTime }: Trajectory, { duration }: Shared): string {
  const { timestep, frames, timeScale } = experiment
  if (experiment.duration > duration) return `it runs longer than the curves’ ${duration}\u202fs`
  const rate = 'fps' in frames ? frames.fps : NaN
  // Rounding aside, a step that is a frame's is the frame's time.
  const astray = timestep.kind === 'per-frame' && !(Math.abs(timestep.step * rate - 1) < 1e-9)
  if (lostTime > 0 || astray || timeScale !== 1 || frames.delta)
    return 'its seconds are not real seconds'
  // A fixed step is behind the clock by less than a step; how far that shows is part of its error.
  return frames.kind === 'steady' || timestep.kind === 'fixed' ? '' : 'its steps differ in length'
}
