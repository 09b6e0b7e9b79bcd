import { simulate } from '../physics/index.ts'
import type { Experiment, FramesChoice } from '../physics/index.ts'
import { spreadOf } from './spreadOf.ts'

/** The frames under which a run must end in the same place to be called framerate-independent. */
const spreadClocks: readonly FramesChoice[] = [
  ...[5, 10, 15, 24, 30, 60, 120, 144, 240].map((fps) => ({ kind: 'steady', fps }) as const),
  { kind: 'jitter', fps: 60, amount: 0.9, seed: 1 },
  { kind: 'hitch', fps: 60, every: 0.7, length: 0.5 },
]

/**
 * The frame-rate spread: how far apart a run ends under different frames, all else equal [m].
 *
 * @throws ExperimentError for an experiment that can't be run
 */
// #region spread
export function frameRateSpread(experiment: Experiment): number {
  return spreadOf(
    spreadClocks.map((frames) => {
      const { drawnS } = simulate({ ...experiment, frames })
      return drawnS[drawnS.length - 1]!
    }),
  )
}
// #endregion
