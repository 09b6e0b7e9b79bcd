import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'

const CUBE_ROOT_OF_2 = 1.2599210498948732
const OUTER = 1 / (2 - CUBE_ROOT_OF_2)
const INNER = -CUBE_ROOT_OF_2 * OUTER

/** Three Verlet steps, forward, back and forward again, whose errors cancel (Yoshida, 1990). */
export const yoshida4 = {
  id: 'yoshida4',
  label: 'Yoshida 4',
  about:
    'Three Verlet steps, the middle one backwards in time, so that their errors cancel: accurate, and keeps the energy for ever.',
  formula: ['Verlet by w₁Δt, w₀Δt, w₁Δt', 'w₁ = 1/(2 − ∛2),  w₀ = −∛2 w₁'],
  order: 4,
  orderWithSpeed: 3,
  // The root of the trace of the three steps' product: where |tr| reaches 2 on the harmonic oscillator.
  stability: 1.573,
  symplectic: true,
  evaluations: { least: 3, most: 6 },
  colour: 5,
  step(motion: Motion): void {
    const { reusable } = motion
    let { s, v } = motion
    if (motion.known === 0) motion.a = motion.acceleration(s, v)
    let { a } = motion
    let first = a
    let taken = 0
    for (;;) {
      const outer = OUTER * motion.dt
      const inner = INNER * motion.dt
      first = a
      // The first part stands by itself: engines run a loop of two better than one of three.
      let before = a
      s = s + (v + 0.5 * before * outer) * outer
      a = motion.acceleration(s, v + before * outer)
      v = v + 0.5 * (before + a) * outer
      for (let part = inner; ; part = outer) {
        if (reusable === 0) a = motion.acceleration(s, v)
        before = a
        s = s + (v + 0.5 * before * part) * part
        a = motion.acceleration(s, v + before * part)
        v = v + 0.5 * (before + a) * part
        if (part === outer) break
      }
      if (!motion.goesOn(s, v, ++taken)) break
      if (reusable === 0) a = motion.acceleration(s, v)
    }
    motion.a = motion.taken < motion.asked ? first : a
  },
} as const satisfies Integrator
