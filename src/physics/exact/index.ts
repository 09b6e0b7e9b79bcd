import type { Experiment } from '../experiment.ts'
import { entry } from '../lists.ts'
import { parseForRun } from '../parse.ts'
import type { Scene } from '../scene.ts'
import type { ExactMotion } from '../state.ts'
import { scenes } from '../scenes/index.ts'

// The phases of this many motions take at most 32 MB.
const MOST_KEPT = 8
const kept = new Map<string, ExactMotion>()

/**
 * The true motion of an experiment's scene and parameters, without frames or steps: in closed form, or as the
 * sum of a series. The error is at most 1e-11 of the distance (1e-11 m below 1 m), or 100 times the effect of the last bits of
 * the parameters and of the time, if that is more. The state is NaN where this can't be promised: after
 * thousands of swings that do not repeat, which means hours with hardly any friction.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function exactMotion(experiment: Experiment): ExactMotion {
  const { scene, parameters } = parseForRun(experiment)
  const key = JSON.stringify([scene, parameters])
  const known = kept.get(key)
  if (known) return known
  const motion = (entry(scenes, scene) as Scene).exact(parameters)
  if (kept.size === MOST_KEPT) kept.delete(kept.keys().next().value!)
  kept.set(key, motion)
  return motion
}
