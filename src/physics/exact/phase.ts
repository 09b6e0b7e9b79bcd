import type { State } from '../state.ts'

/** A span of time with one law, in which s is a polynomial of x, the time since its start in units of `unit`. */
export interface Phase {
  /** Coefficients of s [m], the constant term first. */
  readonly c: readonly number[]
  /** [s] */
  readonly unit: number
  /** How long it lasts [s]. */
  readonly lasts: number
  /** The state at its end. */
  readonly end: State
  /** It ends where the block takes off from a crest. */
  readonly takesOff?: boolean
}

/** The last phase of a motion, with a constant state: at rest, off the track, or NaN if the motion is unknown. */
export function stay(s: number, v: number): Phase {
  return { c: [s], unit: 1, lasts: Infinity, end: { s, v } }
}

/** Sets `into` to the value of a polynomial and to its derivative, by Horner's rule. */
export function evaluate(c: readonly number[], x: number, into: State): State {
  let value = c[c.length - 1]!
  let slope = 0
  for (let i = c.length - 2; i >= 0; i--) {
    slope = slope * x + value
    value = value * x + c[i]!
  }
  into.s = value
  into.v = slope
  return into
}

const point: State = { s: NaN, v: NaN }

/**
 * Where a polynomial takes a value, between 0 and a place where it is on the other side of that value: Newton's method, with
 * bisection wherever that would leave the bracket or not halve the last step (Press et al., Numerical Recipes, rtsafe).
 */
export function crossing(c: readonly number[], target: number, end: number): number {
  const falls = evaluate(c, end, point).s < target
  let low = 0
  let high = end
  let x = end
  let last = end
  for (;;) {
    const { s, v } = evaluate(c, x, point)
    const residual = s - target
    if (residual === 0) return x
    if (residual > 0 === falls) low = x
    else high = x
    let next = x - residual / v
    if (!(next > low && next < high && Math.abs(next - x) <= last / 2))
      next = low + (high - low) / 2
    last = Math.abs(next - x)
    if (last <= Number.EPSILON * next) return next
    x = next
  }
}
