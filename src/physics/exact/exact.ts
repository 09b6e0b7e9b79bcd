import type { Experiment } from '../experiment.ts'
import { show } from '../problems.ts'
import type { State } from '../state.ts'
import { exactMotion } from './index.ts'

/**
 * The true state at a time: distance along the track [m] and speed [m/s], to the error that `exactMotion` promises.
 *
 * @param t a finite time of 0 or more [s]
 * @throws ExperimentError for an experiment that can't be run, RangeError for any other time and if the state is
 * not known to that error
 */
export function exact(experiment: Experiment, t: number): State {
  const motion = exactMotion(experiment)
  if (!(Number.isFinite(t) && t >= 0))
    throw new RangeError(`The motion is known at finite times from 0 s on, not at ${show(t)} s.`)
  const state = motion(t, { s: NaN, v: NaN })
  if (Number.isNaN(state.s)) throw new RangeError(`The motion is not known to 1e-11 at ${t} s.`)
  return state
}
