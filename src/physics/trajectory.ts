import type { ResolvedExperiment } from './experiment.ts'
import type { Outcome, Run } from './run.ts'

/** Everything that happened in a run, a row for every frame; row 0 is the start. */
export interface Trajectory {
  experiment: ResolvedExperiment
  /** How many frames were simulated: each array holds one row more. A run that ends early has fewer than it was asked for. */
  frames: number
  /** On the wall clock [s]. */
  time: Float64Array
  /** The time that the physics state stands at [s]: behind `time` under `fixed` and `capped`, astray under `per-frame`. */
  stateTime: Float64Array
  /** The physics state: distance along the track [m] and speed [m/s]. */
  s: Float64Array
  v: Float64Array
  /** The position that the frame shows [m]. */
  drawnS: Float64Array
  /** Σ friction force × sliding distance so far [J]. */
  heat: Float64Array
  /** Steps that the timestep policy asked for. */
  steps: number
  /** Evaluations of the acceleration, those of steps that were tried and shortened included. */
  evaluations: number
  /** Implicit steps whose equation was not solved to rounding. */
  unsolved: number
  /** Time that the policy dropped [s]. */
  lostTime: number
  /** How the run ended, and when on the clock of `stateTime` [s]. */
  outcome: Outcome
}

/** Takes down a run frame by frame. */
export class Recorder {
  private rows = 0
  private readonly columns: Float64Array[]

  /** `capacity`: how many rows to expect; more are no mistake. */
  constructor(capacity: number) {
    this.columns = Array.from({ length: 6 }, () => new Float64Array(capacity))
  }

  record(run: Run): void {
    if (this.rows === this.columns[0]!.length) this.grow()
    const [time, stateTime, s, v, drawnS, heat] = this.columns as Columns
    const row = this.rows++
    const { motion } = run
    time[row] = run.time
    stateTime[row] = run.stateTime
    s[row] = motion.s
    v[row] = motion.v
    drawnS[row] = run.drawnS
    heat[row] = motion.heat
  }

  trajectory(experiment: ResolvedExperiment, run: Run): Trajectory {
    const { rows } = this
    const [time, stateTime, s, v, drawnS, heat] = this.columns.map((column) =>
      rows === column.length ? column : column.slice(0, rows),
    ) as Columns
    const { steps, evaluations, lostTime, outcome } = run
    return {
      experiment,
      frames: rows - 1,
      time,
      stateTime,
      s,
      v,
      drawnS,
      heat,
      steps,
      evaluations,
      unsolved: run.motion.unsolved,
      lostTime,
      outcome,
    }
  }

  private grow(): void {
    this.columns.forEach((column, i) => {
      const larger = new Float64Array(2 * column.length)
      larger.set(column)
      this.columns[i] = larger
    })
  }
}

type Columns = [Float64Array, Float64Array, Float64Array, Float64Array, Float64Array, Float64Array]
