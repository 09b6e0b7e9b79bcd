import type { Integrator } from '../integrator.ts'

const MOST_ITERATIONS = 39
// Two rounding errors of a number of size 1.
const ROUNDING = 2 * Number.EPSILON

/**
 * The implicit midpoint rule (Gauss, one stage): the slope half-way, at a mean velocity that solves its own equation.
 */
export const implicitMidpoint = {
  id: 'implicit-midpoint',
  label: 'Implicit midpoint',
  about: 'Solves for the mean velocity that agrees with the force half-way: stable at any step.',
  formula: ['v̄ = v + ½ Δt a(s + ½ Δt v̄, v̄)', 's′ = s + v̄ Δt', 'v′ = 2 v̄ − v'],
  order: 2,
  orderWithSpeed: 2,
  stability: Infinity,
  symplectic: true,
  evaluations: { least: 1, most: MOST_ITERATIONS + 1 },
  colour: 6,
  step: (motion) => {
    const { s, v, dt } = motion
    const half = 0.5 * dt
    // The residual of a guess of v̄; the secant through the last two residuals gives the next guess.
    let guess = v
    let residual = half * motion.acceleration(s + half * guess, guess)
    let change = residual
    for (let i = 1; Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)); i++) {
      guess += change
      const next = v - guess + half * motion.acceleration(s + half * guess, guess)
      // Two guesses with the same residual give no secant.
      if (next === residual || i === MOST_ITERATIONS) {
        motion.unsolved++
        break
      }
      // Divide first: the product of two small numbers may underflow to 0 and look solved.
      change *= next / (residual - next)
      residual = next
    }
    motion.s = s + guess * dt
    motion.v = guess + guess - v
  },
} as const satisfies Integrator
