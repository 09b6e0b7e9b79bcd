import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'

/** Forward Euler: the slope at the beginning, kept for the whole step (Euler, 1768). */
export const explicitEuler = {
  id: 'explicit-euler',
  label: 'Explicit Euler',
  about:
    'Moves with the old velocity, then changes it: what “forward Euler” means. Gains energy in every swing.',
  formula: ['s′ = s + v Δt', 'v′ = v + a(s, v) Δt'],
  order: 1,
  orderWithSpeed: 1,
  stability: 0,
  symplectic: false,
  evaluations: { least: 1, most: 1 },
  colour: 0,
  step(motion: Motion): void {
    let { s, v } = motion
    let taken = 0
    do {
      const { dt } = motion
      // #region step
      const a = motion.acceleration(s, v)
      s = s + v * dt
      v = v + a * dt
      // #endregion
      taken++
    } while (motion.goesOn(s, v, taken))
  },
} as const satisfies Integrator
