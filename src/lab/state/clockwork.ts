import { triesOf } from '../../physics/index.ts'
import type { Experiment, Trajectory, Tries } from '../../physics/index.ts'

/** What a run did with time, a value for each of its rows. */
export interface Clockwork {
  /** When frames were, on the wall clock [s]. */
  readonly time: Float64Array
  /** Under `fixed`, the length of its steps [s]; else undefined. */
  readonly step: number | undefined
  /**
   * Under `tolerance`, the steps that were tried; undefined where they are too many to be seen, and under other
   * policies.
   */
  readonly tries: Tries | undefined
  /** Under `fixed`, what is left of the frame time for later steps: gameTime − stateTime − lost [s]. Else zeros. */
  readonly accumulator: Float64Array
  /** Game time that the policy has dropped by then [s]. */
  readonly lost: Float64Array
}

/** With more steps than this a run is not repeated for them. */
const MOST_STEPS = 20_000

const kept = new WeakMap<Trajectory, Clockwork>()

/** A trajectory's clocks, read off its times. */
export function clockworkOf(trajectory: Trajectory): Clockwork {
  const known = kept.get(trajectory)
  if (known) return known
  const { experiment, time, gameTime, stateTime, lostTime, frames } = trajectory
  const { timestep } = experiment
  const step = timestep.kind === 'fixed' ? timestep.step : undefined
  const isTried = timestep.kind === 'tolerance' && trajectory.steps <= MOST_STEPS
  const tries = isTried ? triesOf(experiment as Experiment) : undefined
  const cap = timestep.kind === 'fixed' ? timestep.cap : Infinity
  // What the frames so far exceed the cap by.
  let excess = 0
  const lost = new Float64Array(frames + 1)
  const accumulator = new Float64Array(frames + 1)
  for (let row = 1; row <= frames; row++) {
    const late = gameTime[row]! - stateTime[row]!
    excess += Math.max(0, gameTime[row]! - gameTime[row - 1]! - cap)
    // The accumulator holds less than a step, so that the whole steps of a delay are those that were dropped.
    const dropped =
      step === undefined ? late : excess + Math.floor((late - excess) / step + 1e-6) * step
    if (lostTime > 0) lost[row] = Math.max(lost[row - 1]!, Math.min(dropped, lostTime))
    if (step !== undefined) accumulator[row] = Math.max(0, late - lost[row]!)
  }
  const { kind } = trajectory.outcome
  if (kind === 'left-the-track' || kind === 'diverged') {
    // The state's time is that of the end, inside the last frame: nothing is left to be stepped.
    accumulator[frames] = 0
    lost[frames] = lostTime
  }
  const clockwork = { time, step, tries, accumulator, lost }
  kept.set(trajectory, clockwork)
  return clockwork
}

/** Whether the steps of a run have times of their own, which are not those of its frames. */
export function hasOwnSteps({ experiment }: Trajectory): boolean {
  const { kind } = experiment.timestep
  return kind === 'fixed' || kind === 'tolerance'
}

/** When a game's clock shows a time, on the wall clock, within the frame in which that falls [s]. */
export function onTheWall({ time, gameTime }: Trajectory, at: number): number {
  let row = 1
  let high = gameTime.length - 1
  while (row < high) {
    const middle = (row + high) >> 1
    if (gameTime[middle]! < at) row = middle + 1
    else high = middle
  }
  const from = gameTime[row - 1]!
  // Where the two clocks are one, not a bit is to change.
  if (!(row <= high) || (from === time[row - 1] && gameTime[row] === time[row])) return at
  const part = Math.min(1, (at - from) / (gameTime[row]! - from))
  return time[row - 1]! + part * (time[row]! - time[row - 1]!)
}

/** When the steps that were tried end, those that were kept or those that were taken back [s]. */
export function* triedTimes(
  trajectory: Trajectory,
  { begins, lengths, accepted }: Tries,
  kept: boolean,
): Generator<number> {
  for (let i = 0; i < begins.length; i++) {
    if (accepted[i] !== kept) continue
    // What is kept are two halves.
    if (kept) yield onTheWall(trajectory, begins[i]! + 0.5 * lengths[i]!)
    yield onTheWall(trajectory, begins[i]! + lengths[i]!)
  }
}

/** When the steps of a run under `fixed` end, on the wall clock [s], in the frames of the rows `first` to `last`. */
export function* stepTimes(trajectory: Trajectory, first: number, last: number): Generator<number> {
  const { step, lost } = clockworkOf(trajectory)
  if (step === undefined) return
  const { stateTime } = trajectory
  for (let row = Math.max(1, first); row <= last; row++) {
    const from = stateTime[row - 1]!
    const count = Math.floor((stateTime[row]! - from) / step + 1e-6)
    for (let i = 1; i <= count; i++) yield onTheWall(trajectory, from + i * step + lost[row - 1]!)
  }
}
