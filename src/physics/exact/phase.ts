import type { State } from '../scene.ts'

/** The degree of the polynomial on a bend: the cost of a step grows with its square, the step's length ever less. */
export const DEGREE = 24

/** A stretch of time with one law. In it s is a polynomial of x, the time since its start in units of `unit`. */
export class Phase {
  /** [s] */
  unit = 1
  degree = 0
  /** Coefficients of s [m], the constant one first. */
  readonly c = new Float64Array(DEGREE + 1)
  /** How long it lasts [s], and the state that it ends with. */
  lasts = NaN
  readonly end: State = { s: NaN, v: NaN }

  /** Makes it the last phase, with one state for ever: at rest, off the track, or NaN where the motion is unknown. */
  stay(s: number, v: number): void {
    this.degree = 0
    this.c[0] = this.end.s = s
    this.end.v = v
    this.lasts = Infinity
  }
}

/** Sets `into` to the value of a polynomial and to its derivative, by Horner's rule. */
export function evaluate(
  c: Float64Array,
  offset: number,
  degree: number,
  x: number,
  into: State,
): State {
  let value = c[offset + degree]!
  let slope = 0
  for (let i = offset + degree - 1; i >= offset; i--) {
    slope = slope * x + value
    value = value * x + c[i]!
  }
  into.s = value
  into.v = slope
  return into
}

const point: State = { s: NaN, v: NaN }

/**
 * Where a polynomial takes a value, between 0 and a place where it is on the other side of it: Newton's method, with
 * bisection wherever that would leave the bracket or not halve the last step (Press et al., Numerical Recipes, rtsafe).
 */
export function crossing(c: Float64Array, degree: number, target: number, end: number): number {
  const falls = evaluate(c, 0, degree, end, point).s < target
  let low = 0
  let high = end
  let x = end
  let last = end
  for (;;) {
    const { s, v } = evaluate(c, 0, degree, x, point)
    const missed = s - target
    if (missed === 0) return x
    if (missed > 0 === falls) low = x
    else high = x
    let next = x - missed / v
    if (!(next > low && next < high && Math.abs(next - x) <= last / 2))
      next = low + (high - low) / 2
    last = Math.abs(next - x)
    if (last <= Number.EPSILON * next) return next
    x = next
  }
}
