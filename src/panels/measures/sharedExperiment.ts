import { parseExperiment } from '../../physics/index.ts'
import type { Experiment } from '../../physics/index.ts'

/** No run that is one of many is longer [s]. */
const LONGEST = 20

/**
 * What all runs of a measurement share: the scene, its parameters, and a duration within bounds.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function sharedExperiment(experiment: Experiment): Experiment {
  const { scene, parameters, duration } = parseExperiment(experiment)
  return { scene, parameters, duration: Math.min(duration, LONGEST) }
}
