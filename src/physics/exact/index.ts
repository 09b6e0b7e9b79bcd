import type { Experiment } from '../experiment.ts'
import { entry } from '../lists.ts'
import { parseExperiment } from '../parse.ts'
import type { ExactMotion, Scene, State } from '../scene.ts'
import { scenes } from '../scenes/index.ts'

const MOST_KEPT = 16
const kept = new Map<string, ExactMotion>()

/**
 * The true motion of an experiment's scene and parameters: no frames, no steps. For the closed forms and the series
 * behind it see each scene.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function exactMotion(experiment: Experiment): ExactMotion {
  const { scene, parameters } = experiment
  // Only these two matter; what was solved for them serves again, and the latest few are kept.
  const key = JSON.stringify([scene, parameters])
  const known = kept.get(key)
  if (known) return known
  const resolved = parseExperiment({ scene, ...(parameters && { parameters }) })
  const motion = (entry(scenes, resolved.scene) as Scene).exact(resolved.parameters)
  if (kept.size === MOST_KEPT) kept.delete(kept.keys().next().value!)
  kept.set(key, motion)
  return motion
}

/**
 * The true state at the time t [s], 0 or later: distance along the track [m] and speed [m/s]. NaN where the motion has
 * more than some hundred thousand swings before t and does not repeat itself, which is only where next to no friction
 * acts for hours.
 *
 * @throws ExperimentError for an experiment that can't be run, RangeError for a time that is not 0 or more
 */
export function exact(experiment: Experiment, t: number): State {
  if (!(t >= 0)) throw new RangeError(`The motion is known from 0 s on, not at ${String(t)} s.`)
  return exactMotion(experiment)(t, { s: 0, v: 0 })
}
