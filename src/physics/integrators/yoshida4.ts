import type { Integrator } from '../integrator.ts'

const CUBE_ROOT_OF_2 = 1.2599210498948732
const OUTER = 1 / (2 - CUBE_ROOT_OF_2)
const INNER = -CUBE_ROOT_OF_2 * OUTER

/** Three Verlet steps, forward, back and forward again, whose errors cancel (Yoshida, 1990). */
export const yoshida4 = {
  id: 'yoshida4',
  label: 'Yoshida 4',
  about:
    'Three Verlet steps, the middle one backwards, so that errors cancel: accurate, and keeps the energy.',
  formula: ['Verlet by w₁Δt, w₀Δt, w₁Δt', 'w₁ = 1/(2 − ∛2),  w₀ = −∛2 w₁'],
  order: 4,
  orderWithSpeed: 3,
  // The root of the trace of the three steps' product: where |tr| reaches 2 on the harmonic oscillator.
  stability: 1.573,
  symplectic: true,
  evaluations: { least: 3, most: 6 },
  colour: 5,
  step: (motion) => {
    const { dt, reusable } = motion
    let { s, v } = motion
    if (!motion.known) motion.a = motion.acceleration(s, v)
    let { a } = motion
    for (let part = 0; part < 3; part++) {
      const length = (part === 1 ? INNER : OUTER) * dt
      if (part > 0 && !reusable) a = motion.acceleration(s, v)
      const before = a
      s = s + (v + 0.5 * before * length) * length
      a = motion.acceleration(s, v + before * length)
      v = v + 0.5 * (before + a) * length
    }
    motion.s = s
    motion.v = v
    motion.a = a
    motion.known = reusable
  },
} as const satisfies Integrator
