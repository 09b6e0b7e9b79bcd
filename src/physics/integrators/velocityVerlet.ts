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
  step(motion: Motion): void {
    const { reusable } = motion
    let { s, v } = motion
    if (motion.known === 0) motion.a = motion.acceleration(s, v)
    let { a } = motion
    let before = a
    let taken = 0
    for (;;) {
      const { dt } = motion
      // #region step
      before = a
      s = s + (v + 0.5 * before * dt) * dt
      a = motion.acceleration(s, v + before * dt)
      v = v + 0.5 * (before + a) * dt
      // #endregion
      if (!motion.goesOn(s, v, ++taken)) break
      // This step's a′ is the next step's a, unless the force looks at the velocity.
      if (reusable === 0) a = motion.acceleration(s, v)
    }
    motion.a = motion.taken < motion.asked ? before : a
  },
} as const satisfies Integrator
