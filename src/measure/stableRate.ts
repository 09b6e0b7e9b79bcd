import { integrators, parseExperiment } from '../physics/index.ts'
import type { Experiment, Integrator } from '../physics/index.ts'

/**
 * The frame rate below which theory says that a run blows up [fps]: a step a frame is stable for ωΔt below the method's
 * limit, and the spring's ω is √(k/m), so that rate = ω / limit. 0 for a method that never blows up, Infinity for one
 * that always does; undefined where theory has nothing to say: in other scenes, where a step is not a frame, and where
 * friction acts and stops are located, since the turns cut the steps unevenly.
 *
 * @throws ExperimentError for a spring that can't be run
 */
export function stableRate(experiment: Experiment): number | undefined {
  if (experiment.scene !== 'spring') return undefined
  const { parameters, timestep, integrator, stopping } = parseExperiment(experiment)
  if (timestep.kind !== 'variable') return undefined
  if (stopping === 'located' && parameters.muStatic! > 0) return undefined
  const { stability }: Integrator = integrators.find(({ id }) => id === integrator)!
  return Math.sqrt(parameters.stiffness! / parameters.mass!) / stability
}
