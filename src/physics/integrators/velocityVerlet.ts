import type { Integrator } from '../integrator.ts'

/** Velocity Verlet (Swope et al., 1982), with a predicted velocity where the force depends on v. */
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
  step: (motion) => {
    // #region step
    const { s, v, dt } = motion
    if (!motion.known) motion.a = motion.acceleration(s, v)
    const { a } = motion
    motion.s = s + (v + 0.5 * a * dt) * dt
    motion.a = motion.acceleration(motion.s, v + a * dt)
    motion.v = v + 0.5 * (a + motion.a) * dt
    // It serves the next step too, where the force ignores v.
    motion.known = motion.reusable
    // #endregion
  },
} as const satisfies Integrator
