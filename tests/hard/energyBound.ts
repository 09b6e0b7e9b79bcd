import { integrators, scenes } from '../../src/physics/index.ts'
import type {
  Integrator,
  ResolvedExperiment,
  Scene,
  SceneId,
  Trajectory,
} from '../../src/physics/index.ts'

export const sceneOf = (id: SceneId): Scene => scenes.find((scene) => scene.id === id)!
export const methodOf = (id: string): Integrator => integrators.find((method) => method.id === id)!

/** What the potential energy per mass is made of, in size, before its parts cancel. */
export function heights({ experiment, s }: Trajectory, row: number): number {
  const {
    gravity = 0,
    stiffness = 0,
    mass = 1,
    radius = 0,
    bendRadius = 0,
    crestRadius = 0,
    length = 0,
  } = experiment.parameters
  const far =
    Math.max(Math.abs(s[row]!), Math.abs(s[row - 1]!)) + radius + bendRadius + crestRadius + length
  return gravity * far + (stiffness / mass) * far * far
}

/**
 * What a step of order p may add to the energy, per mass. With V the largest speed on the way, A the largest acceleration
 * and Λ the largest rate at which the law changes, no derivative of the motion is larger than U = V + A/Λ times a power
 * of Λ. A step misses s by some (Λ Δt)ᵖ⁺¹ U/Λ and v by (Λ Δt)ᵖ⁺¹ U; the energy's slopes are at most Λ U and U: in all
 * 2 (Λ Δt)ᵖ⁺¹ U², here written so that Λ may be 0. Undefined where the step does not resolve the motion: Λ Δt above ½.
 */
export function energyErrorOfStep(run: Trajectory, row: number, dt: number): number | undefined {
  const { experiment, s, v } = run
  const method = methodOf(experiment.integrator)
  const law = lawOf(experiment.parameters)
  const far = Math.max(Math.abs(s[row]!), Math.abs(s[row - 1]!))
  const weight = law.weight + law.stiffness * far
  // A block may be faster inside a frame than at both ends.
  const V = Math.max(Math.abs(v[row]!), Math.abs(v[row - 1]!)) + weight * dt
  const A = weight + law.stiffness * V * dt + law.perSquare * V * V
  const rate = law.rate(V)
  if (rate * dt > 0.5) return undefined
  const { drag, muKinetic, track } = sceneOf(experiment.scene).law(experiment.parameters)
  const dependsOnSpeed =
    drag > 0 || (muKinetic > 0 && track.some(({ curvature }) => curvature !== 0))
  const order = dependsOnSpeed ? method.orderWithSpeed : method.order
  return 2 * (rate * dt) ** (order - 1) * (dt * (rate * V + A)) ** 2
}

/** Bounds of a scene's law: of the forces per mass, of what they gain with s and with v², and of the rate of change. */
export function lawOf(parameters: ResolvedExperiment['parameters']) {
  const { gravity = 0, mass = 1, drag = 0, muKinetic = 0 } = parameters
  const radius = parameters.radius ?? parameters.bendRadius ?? parameters.crestRadius
  const frictionFactor = 1 + muKinetic
  const stiffness = (parameters.stiffness ?? 0) / mass
  const curvature = radius ? 1 / radius : 0
  const k = drag / mass
  return {
    weight: frictionFactor * gravity,
    stiffness,
    perSquare: frictionFactor * curvature + k,
    rate: (speed: number) =>
      Math.sqrt(stiffness) +
      Math.sqrt(gravity * frictionFactor * curvature) +
      Math.sqrt(gravity * k) +
      (frictionFactor * curvature + 2 * k) * speed,
  }
}
