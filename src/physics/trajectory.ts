import type { ResolvedExperiment } from './experiment.ts'
import type { Outcome, Run } from './run.ts'

/** A recorded run with a row for every frame; row 0 is the start. */
export interface Trajectory {
  experiment: ResolvedExperiment
  /** Number of simulated frames: each array has one row more. A run that ends early has fewer frames than requested. */
  frames: number
  /** Wall-clock time [s]. */
  time: Float64Array
  /**
   * The game's time [s]: `time` as the game measures its frames, times the time scale. Where nothing is said of both,
   * `time`.
   */
  gameTime: Float64Array
  /**
   * The time that the physics state stands at [s]: behind `gameTime` under `fixed` and `capped`, unrelated under `per-frame`.
   */
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

const columns = ['time', 'gameTime', 'stateTime', 's', 'v', 'drawnS', 'heat', 'work'] as const

type Columns = Pick<Trajectory, (typeof columns)[number]>

/** Records a run frame by frame. */
export class Recorder {
  private rows = 0
  private columns: Columns

  /** `capacity`: the expected number of rows; the arrays grow if there are more. */
  constructor(capacity: number) {
    this.columns = columnsOf(() => new Float64Array(capacity))
  }

  record(run: Run): void {
    const row = this.rows++
    // Random clocks exceed the expected number of frames by little.
    if (row === this.columns.time.length) this.resize(row + (row >> 4) + 16)
    const { columns } = this
    const { motion } = run
    columns.time[row] = run.time
    columns.gameTime[row] = run.gameTime
    columns.stateTime[row] = run.stateTime
    columns.s[row] = motion.s
    columns.v[row] = motion.v
    columns.drawnS[row] = run.drawnS
    columns.heat[row] = motion.heat
    columns.work[row] = motion.work
  }

  trajectory(experiment: ResolvedExperiment, run: Run): Trajectory {
    this.resize(this.rows)
    const { frames, steps, evaluations, lostTime, outcome, abandoned } = run
    const { unsolved } = run.motion
    return {
      ...{ experiment, frames, ...this.columns },
      ...{ steps, evaluations, unsolved, abandoned, lostTime, outcome },
    }
  }

  private resize(rows: number): void {
    const { columns } = this
    if (rows !== columns.time.length) this.columns = columnsOf((key) => resized(columns[key], rows))
  }
}

function columnsOf(make: (key: keyof Columns) => Float64Array): Columns {
  return Object.fromEntries(columns.map((key) => [key, make(key)])) as unknown as Columns
}

function resized(column: Float64Array, rows: number): Float64Array {
  const other = new Float64Array(rows)
  other.set(column.subarray(0, rows))
  return other
}
