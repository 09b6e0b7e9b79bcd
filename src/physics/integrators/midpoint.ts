import type { Integrator } from '../integrator.ts'

/** The explicit midpoint method (Runge, 1895). */
export const midpoint = {
  id: 'midpoint',
  label: 'Midpoint',
  about: 'Half a step to look at the slope there, then the whole step with it.',
  formula: ['v½ = v + ½ a(s, v) Δt', 's′ = s + v½ Δt', 'v′ = v + a(s + ½ v Δt, v½) Δt'],
  order: 2,
  orderWithSpeed: 2,
  stability: 0,
  symplectic: false,
  evaluations: { least: 2, most: 2 },
  colour: 3,
  step: (motion) => {
    const { s, v, dt } = motion
    const vHalf = v + 0.5 * dt * motion.acceleration(s, v)
    motion.v = v + dt * motion.acceleration(s + 0.5 * dt * v, vHalf)
    motion.s = s + dt * vHalf
  },
} as const satisfies Integrator
