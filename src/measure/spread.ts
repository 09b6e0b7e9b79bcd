import { timesteps } from '../physics/index.ts'
import type { Outcome, Trajectory } from '../physics/index.ts'
import { scaleOf } from './rounding.ts'

/** How far apart the runs of one experiment end under different frames. */
export interface Spread {
  /** The outcomes of the runs, each once. */
  readonly outcomes: readonly Outcome['kind'][]
  /**
   * All of them ended on the track, moving or at rest, or all left it, or all diverged. Where they do not agree, no
   * distance says how far apart they are.
   */
  readonly agree: boolean
  /** Some of them could not keep to the tolerance asked for. */
  readonly abandoned: boolean
  /** Largest − smallest final position [m]. */
  readonly distance: number
  /** The time at which the first and the last of them left the track [s]; NaN where none did. */
  readonly earliest: number
  readonly latest: number
  /** The length of the path, against which rounding is measured [m]. */
  readonly scale: number
}

/** How far apart some runs end; there is at least one. */
export function spreadOf(runs: readonly Trajectory[]): Spread {
  const ends = runs.map(({ drawnS }) => drawnS[drawnS.length - 1]!)
  const left = runs.filter(({ outcome }) => outcome.kind === 'left-the-track').map(endTime)
  const outcomes = [...new Set(runs.map(({ outcome }) => outcome.kind))]
  return {
    outcomes,
    agree: new Set(outcomes.map((kind) => (kind === 'at-rest' ? 'moving' : kind))).size === 1,
    abandoned: runs.some(({ abandoned }) => abandoned),
    distance: Math.max(...ends) - Math.min(...ends),
    earliest: left.length > 0 ? Math.min(...left) : NaN,
    latest: left.length > 0 ? Math.max(...left) : NaN,
    scale: scaleOf(runs[0]!.experiment).length,
  }
}

/** When a run ended, on the wall clock [s]: to the bit, or to a frame where the policy lets the clocks stray. */
function endTime({ experiment, outcome, stateTime, time, lostTime }: Trajectory): number {
  const policy = timesteps.find(({ id }) => id === experiment.timestep.kind)!
  const { timeScale, frames } = experiment
  if (!policy.losesTime && lostTime === 0 && !frames.delta) return outcome.time / timeScale
  const before = Math.max(0, stateTime.findIndex((t) => t >= outcome.time) - 1)
  return (outcome.time - stateTime[before]!) / timeScale + time[before]!
}
