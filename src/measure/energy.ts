import { scenes } from '../physics/index.ts'
import type { Scene, Trajectory } from '../physics/index.ts'

/** Kinetic and potential energy at each row of a trajectory [J]; potential energy is 0 where its scene says. */
export function mechanicalEnergy({ experiment, s, v }: Trajectory): Float64Array {
  const scene: Scene = scenes.find(({ id }) => id === experiment.scene)!
  const { parameters } = experiment
  return s.map((position, row) => {
    const speed = v[row]!
    return parameters.mass! * (0.5 * speed * speed + scene.potential(parameters, position))
  })
}

/**
 * Kinetic + potential + heat − work of the belt − what the run began with, at each row [J]. The heat is the work of
 * friction and drag, force × distance, so that a method which invents energy or loses it shows it here.
 */
export function energyResidual(trajectory: Trajectory): Float64Array {
  const energy = mechanicalEnergy(trajectory)
  const { heat, work } = trajectory
  const start = energy[0]!
  return energy.map((value, row) => value + heat[row]! - work[row]! - start)
}
