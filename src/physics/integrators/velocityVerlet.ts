import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'

/** Velocity Verlet (Swope et al., 1982), with a predicted velocity where the force asks for one. */
export const velocityVerlet = {
  id: 'velocity-verlet',
  label: 'Velocity Verlet',
  about:
    'Moves along a parabola, then changes the velocity by the mean of both ends’ accelerations: exact where the force is constant.',
  formula: [
    'a = a(s, v)',
    's′ = s + v Δt + ½ a Δt²',
    'a′ = a(s′, v + a Δt)',
    'v′ = v + ½ (a + a′) Δt',
  ],
  order: 2,
  orderWithSpeed: 2,
  stability: 2,
  symplectic: true,
  evaluations: { least: 1, most: 2 },
  colour: 2,
  // #region step
  step(motion: Motion): void {
    const { s, v, dt } = motion
    // The last step's a′ is this step's a, unless the force looks at the velocity.
    if (!motion.known) motion.accelerate()
    const { a } = motion
    motion.s = s + (v + 0.5 * a * dt) * dt
    motion.v = v + a * dt
    motion.accelerate()
    motion.v = v + 0.5 * (a + motion.a) * dt
    motion.known = motion.reusable
  },
  // #endregion
} as const satisfies Integrator
