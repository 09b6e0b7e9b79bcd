import type { Integrator } from '../integrator.ts'

/** Semi-implicit (symplectic) Euler (de Vogelaere, 1956): the paper's step, which the paper calls forward Euler. */
export const semiImplicitEuler = {
  id: 'semi-implicit-euler',
  label: 'Semi-implicit Euler',
  about: 'Changes the velocity, then moves with the new one: the paper’s step, and most engines’.',
  formula: ['v′ = v + a(s, v) Δt', 's′ = s + v′ Δt'],
  order: 1,
  orderWithSpeed: 1,
  stability: 2,
  symplectic: true,
  evaluations: { least: 1, most: 1 },
  colour: 1,
  step: (motion) => {
    // #region step
    const { s, v, dt } = motion
    motion.v = v + motion.acceleration(s, v) * dt
    motion.s = s + motion.v * dt
    // #endregion
  },
} as const satisfies Integrator
