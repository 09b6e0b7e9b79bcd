import { simulate, integrators, parseExperiment } from '../physics/index.ts'
import type { IntegratorId, Experiment, Integrator } from '../physics/index.ts'

/** Steps of each trial run: at a hundredth above a limit every method has grown beyond all bounds by then. */
const STEPS = 100000

/** Whether a run of the frictionless spring at that ωΔt stays bounded: the step is kept, the spring made stiffer. */
export function staysBounded(integrator: IntegratorId, omegaDt: number): boolean {
  const step = 1 / 60
  const { outcome } = simulate({
    scene: 'spring',
    parameters: {
      angle: 0,
      stiffness: (omegaDt / step) ** 2,
      mass: 1,
      muStatic: 0,
      muKinetic: 0,
      position: 1,
      speed: 0,
    },
    integrator,
    timestep: { kind: 'fixed', step },
    // Long frames of many steps: only the outcome is of interest.
    frames: { kind: 'steady', fps: 1 },
    duration: STEPS * step,
  })
  return outcome.kind !== 'diverged'
}

/**
 * The largest ωΔt at which a method's run of the frictionless spring stays bounded, by bisection between two bounds.
 * Returns 0 where even the smaller of them blows up, Infinity where the larger does not.
 */
export function stabilityLimit(integrator: IntegratorId, smallest = 0.25, largest = 1000): number {
  if (!staysBounded(integrator, smallest)) return 0
  if (staysBounded(integrator, largest)) return Infinity
  let stable = smallest
  let unstable = largest
  while (unstable - stable > 1e-4 * stable) {
    const middle = (stable + unstable) / 2
    if (staysBounded(integrator, middle)) stable = middle
    else unstable = middle
  }
  return stable
}

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
