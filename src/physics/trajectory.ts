import type { ResolvedExperiment } from './experiment.ts'
import type { Outcome, Run } from './run.ts'

/** A recorded run with a row for every frame; row 0 is the start. */
export interface Trajectory {
  experiment: ResolvedExperiment
  /** Number of simulated frames: each array has one row more. A run that ends early has fewer frames than requested. */
  frames: number
  /** Wall-clock time [s]. */
  time: Float64Array
  /** The time that the physics state stands at [s]: behind `time` under `fixed` and `capped`, unrelated under `per-frame`. */
  stateTime: Float64Array
  /** The physics state: distance along the track [m] and speed [m/s]. */
  s: Float64Array
  v: Float64Array
  /** The position that the frame shows [m]. */
  drawnS: Float64Array
  /** Heat so far: the work of friction and drag, Σ force × distance [J]. */
  heat: Float64Array
  /** The work of a moving belt so far [J]: 0 in every other scene. */
  work: Float64Array
  /** Steps that the timestep policy asked for. */
  steps: number
  /** Evaluations of the acceleration, including those of steps that were tried and shortened. */
  evaluations: number
  /** Implicit steps whose equation was not solved to rounding. */
  unsolved: number
  /** The outcome is `diverged` because the policy could not meet its tolerance within the steps that a run may take. */
  abandoned: boolean
  /** Time that the policy dropped [s]. */
  lostTime: number
  /** How the run ended, and when, on the physics clock [s]. */
  outcome: Outcome
}

/** Records a run frame by frame. */
export class Recorder {
  private rows = 0
  private time: Float64Array
  private stateTime: Float64Array
  private s: Float64Array
  private v: Float64Array
  private drawnS: Float64Array
  private heat: Float64Array
  private work: Float64Array

  /** `capacity`: the expected number of rows; the arrays grow if there are more. */
  constructor(capacity: number) {
    this.time = new Float64Array(capacity)
    this.stateTime = new Float64Array(capacity)
    this.s = new Float64Array(capacity)
    this.v = new Float64Array(capacity)
    this.drawnS = new Float64Array(capacity)
    this.heat = new Float64Array(capacity)
    this.work = new Float64Array(capacity)
  }

  record(run: Run): void {
    const row = this.rows++
    // Random clocks exceed the expected number of frames by little.
    if (row === this.time.length) this.resize(row + (row >> 4) + 16)
    const { motion } = run
    this.time[row] = run.time
    this.stateTime[row] = run.stateTime
    this.s[row] = motion.s
    this.v[row] = motion.v
    this.drawnS[row] = run.drawnS
    this.heat[row] = motion.heat
    this.work[row] = motion.work
  }

  trajectory(experiment: ResolvedExperiment, run: Run): Trajectory {
    this.resize(this.rows)
    const { time, stateTime, s, v, drawnS, heat, work } = this
    const { frames, steps, evaluations, lostTime, outcome, abandoned } = run
    const { unsolved } = run.motion
    return {
      ...{ experiment, frames, time, stateTime, s, v, drawnS, heat, work },
      ...{ steps, evaluations, unsolved, abandoned, lostTime, outcome },
    }
  }

  private resize(rows: number): void {
    if (rows === this.time.length) return
    this.time = resized(this.time, rows)
    this.stateTime = resized(this.stateTime, rows)
    this.s = resized(this.s, rows)
    this.v = resized(this.v, rows)
    this.drawnS = resized(this.drawnS, rows)
    this.heat = resized(this.heat, rows)
    this.work = resized(this.work, rows)
  }
}

function resized(column: Float64Array, rows: number): Float64Array {
  const other = new Float64Array(rows)
  other.set(column.length > rows ? column.subarray(0, rows) : column)
  return other
}
