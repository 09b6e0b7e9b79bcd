import type { Integrator } from '../integrator.ts'

/** Forward Euler: the slope at the beginning, kept for the whole step (Euler, 1768). */
export const explicitEuler = {
  id: 'explicit-euler',
  label: 'Explicit Euler',
  about:
    'Moves with the old velocity, then changes it (“forward Euler”). Gains energy in every swing.',
  formula: ['s′ = s + v Δt', 'v′ = v + a(s, v) Δt'],
  order: 1,
  orderWithSpeed: 1,
  stability: 0,
  symplectic: false,
  evaluations: { least: 1, most: 1 },
  colour: 0,
  step: (motion) => {
    // #region step
    const { s, v, dt } = motion
    motion.v = v + motion.acceleration(s, v) * dt
    motion.s = s + v * dt
    // #endregion
  },
} as const satisfies Integrator
