import type { Integrator } from '../integrator.ts'

/** The classical Runge–Kutta method (Kutta, 1901). */
export const rk4 = {
  id: 'rk4',
  label: 'Runge–Kutta 4',
  about:
    'The weighted mean of four slopes, two of them at half the step. Very accurate, and slowly loses energy.',
  formula: [
    'a₁ = a(s, v)',
    'v₂ = v + ½ a₁ Δt,  a₂ = a(s + ½ v Δt, v₂)',
    'v₃ = v + ½ a₂ Δt,  a₃ = a(s + ½ v₂ Δt, v₃)',
    'v₄ = v + a₃ Δt,  a₄ = a(s + v₃ Δt, v₄)',
    's′ = s + (v + 2 v₂ + 2 v₃ + v₄) Δt/6',
    'v′ = v + (a₁ + 2 a₂ + 2 a₃ + a₄) Δt/6',
  ],
  order: 4,
  orderWithSpeed: 4,
  stability: 2 * Math.SQRT2,
  symplectic: false,
  evaluations: { least: 4, most: 4 },
  colour: 4,
  step: (motion) => {
    const { s, v, dt } = motion
    const half = 0.5 * dt
    const a1 = motion.acceleration(s, v)
    const v2 = v + half * a1
    const a2 = motion.acceleration(s + half * v, v2)
    const v3 = v + half * a2
    const a3 = motion.acceleration(s + half * v2, v3)
    const v4 = v + dt * a3
    const a4 = motion.acceleration(s + dt * v3, v4)
    motion.s = s + (dt * (v + 2 * (v2 + v3) + v4)) / 6
    motion.v = v + (dt * (a1 + 2 * (a2 + a3) + a4)) / 6
  },
} as const satisfies Integrator
