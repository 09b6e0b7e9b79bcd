import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'

const MOST_ITERATIONS = 40
// Two rounding errors of a number of size one.
const ROUNDING = 2 * Number.EPSILON

/** The implicit midpoint rule (Gauss, one stage): the slope half-way, at a mean velocity that solves its own equation. */
export const implicitMidpoint = {
  id: 'implicit-midpoint',
  label: 'Implicit midpoint',
  about:
    'Solves for the mean velocity that agrees with the force half-way: stable at any step, however stiff the spring.',
  formula: ['v̄ = v + ½ Δt a(s + ½ Δt v̄, v̄)', 's′ = s + v̄ Δt', 'v′ = 2 v̄ − v'],
  order: 2,
  orderWithSpeed: 2,
  stability: Infinity,
  symplectic: true,
  evaluations: { least: 1, most: MOST_ITERATIONS },
  colour: 6,
  step(motion: Motion): void {
    const { dt } = motion
    const half = 0.5 * dt
    let { s, v } = motion
    do {
      // By how much a guess of v̄ misses its equation; the secant through the last two misses gives the next guess.
      let guess = v
      let miss = half * motion.acceleration(s + half * guess, guess)
      let change = miss
      let iterations = 1
      while (
        Math.abs(change) > ROUNDING * (Math.abs(guess) + Math.abs(v)) &&
        iterations < MOST_ITERATIONS
      ) {
        guess += change
        const next = v - guess + half * motion.acceleration(s + half * guess, guess)
        // Two guesses that miss alike point nowhere.
        if (next === miss) iterations = MOST_ITERATIONS
        // The quotient first: the product of two small numbers may underflow, and look as if solved.
        else change *= next / (miss - next)
        miss = next
        iterations++
      }
      if (iterations >= MOST_ITERATIONS) motion.leaveUnsolved()
      s = s + guess * dt
      v = guess + guess - v
    } while (motion.goesOn(s, v))
  },
} as const satisfies Integrator
