/**
 * Sine and cosine from + − × / alone. `Math.sin` differs in its last bits from engine to engine, even between
 * two versions of one; these give the same bits everywhere, within 1 ulp of the true value.
 */

const TWO_OVER_PI = 2 / Math.PI

// π/2 in three parts of 33, 33 and 53 bits: the product of a small whole number with the first two is exact
// (Cody & Waite, Software Manual for the Elementary Functions, 1980).
const HALF_PI_1 = 1.5707963267341256
const HALF_PI_2 = 6.077100506303966e-11
const HALF_PI_3 = 2.0222662487959506e-21

// Beyond this the reduction loses digits. No angle on a track comes near it: only a step that has
// already diverged asks for more, and any finite answer will do.
const LARGEST = 1e9

// Minimax polynomials for both up to π/4 (fdlibm, Sun Microsystems, 1993): as accurate as Taylor's, and shorter.
export const S3 = -1.66666666666666324348e-1
export const S5 = 8.33333333332248946124e-3
export const S7 = -1.98412698298579493134e-4
export const S9 = 2.75573137070700676789e-6
export const S11 = -2.50507602534068634195e-8
export const S13 = 1.58969099521155010221e-10
export const C4 = 4.16666666666666019037e-2
export const C6 = -1.38888888888741095749e-3
export const C8 = 2.48015872894767294178e-5
export const C10 = -2.75573143513906633035e-7
export const C12 = 2.0875723212981748279e-9
export const C14 = -1.13596475577881948265e-11

/**
 * The sine and cosine of one angle: set `angle` [rad], call `find`, read `sin` and `cos`. Numbers stand in fields, since
 * engines box numbers that are passed to a function or returned from it.
 */
export class SinCos {
  angle = NaN
  /** A correction to an angle of at most π/4, smaller than its ulp [rad]. */
  tail = 0
  sin = NaN
  cos = NaN
  /** The angle of the present `sin` and `cos`, so that a repeated request costs nothing. */
  private found = NaN
  // |angle| reduced by whole quarter turns, as a head and a low part [rad]; the number of quarter turns.
  private rest = NaN
  private digits = NaN
  private quarters = 0

  /** Sets `sin` and `cos` to those of `angle`. Odd and even to the bit: sin −x = −sin x. */
  find(): void {
    const { angle } = this
    if (angle === this.found) return
    this.found = angle
    let x = Math.abs(angle)
    let digits = this.tail
    let quarters = 0
    if (!(x <= Math.PI / 4)) {
      this.reduce()
      x = this.rest
      digits = this.digits
      quarters = this.quarters
    }
    const z = x * x
    const w = z * z
    // In two parts each, which a processor evaluates in parallel.
    const sineTail = S3 + z * (S5 + z * (S7 + z * S9) + z * w * (S11 + z * S13))
    const cosineTail = C4 + z * (C6 + z * C8) + z * w * (C10 + z * (C12 + z * C14))
    const head = 1 - 0.5 * z
    const sin = x + (x * z * sineTail + digits * head)
    // (1 − head) − z/2 is exact, and restores what `head` lost by rounding.
    const cos = head + (1 - head - 0.5 * z + (w * cosineTail - x * digits))
    // After a quarter turn, sine and cosine swap.
    const size = quarters & 1 ? cos : sin
    const other = quarters & 1 ? sin : cos
    this.sin = (quarters & 2) > 0 !== angle < 0 ? -size : size
    this.cos = (quarters + 1) & 2 ? -other : other
  }

  private reduce(): void {
    const size = Math.abs(this.angle)
    this.rest = 0 * size
    this.digits = this.quarters = 0
    if (!(size < LARGEST)) return
    const quarters = Math.round(size * TWO_OVER_PI)
    const near = size - quarters * HALF_PI_1
    const correction = quarters * HALF_PI_2
    const rest = near - correction
    this.rest = rest
    this.digits = near - rest - correction - quarters * HALF_PI_3
    this.quarters = quarters
  }
}

/** The sine and cosine of an angle [rad]. */
export function sinCos(angle: number): SinCos {
  const result = new SinCos()
  result.angle = angle
  result.find()
  return result
}

const DEGREE = Math.PI / 180
// The rounding error of π/180.
const DEGREE_REST = 2.9486522708701687e-19

/** Converts degrees to radians. */
export function radians(degrees: number): number {
  return degrees * DEGREE
}

/**
 * The sine and cosine of an angle in degrees from −90° to 90°, within 1 ulp, and exact at its ends: a wall has no
 * normal force at all, not 6e-17 of one.
 */
export function sinCosDegrees(angle: number): SinCos {
  const size = Math.abs(angle)
  const mirrored = size > 45
  // Exact: the two are within a factor of two of each other (Sterbenz).
  const degrees = mirrored ? 90 - size : size
  const product = degrees * DEGREE
  const result = new SinCos()
  result.angle = product
  result.tail = productError(degrees, DEGREE, product) + degrees * DEGREE_REST
  result.find()
  // Made equal: on a slope of 45° with a coefficient of 1, friction exactly balances gravity.
  if (size === 45) result.sin = result.cos = Math.SQRT1_2
  if (mirrored) [result.sin, result.cos] = [result.cos, result.sin]
  if (angle < 0) result.sin = -result.sin
  return result
}

/** The rounding error of a product of two numbers (Dekker, 1971). */
function productError(a: number, b: number, product: number): number {
  const aHigh = upperHalf(a)
  const bHigh = upperHalf(b)
  const aLow = a - aHigh
  const bLow = b - bHigh
  return aLow * bLow - (product - aHigh * bHigh - aLow * bHigh - aHigh * bLow)
}

/** The leading 26 bits of a number (Veltkamp's splitting, by 2²⁷ + 1). */
function upperHalf(x: number): number {
  const scaled = x * 134217729
  return scaled - (scaled - x)
}

/**
 * f(x)/x from f(x) and x, for functions like the sine that are ≈ x near 0: 1 there. Formulas in these tend to their
 * limits (no drag, no spring) without losing digits in a quotient of small numbers.
 */
export function cardinal(value: number, x: number): number {
  return x === 0 ? 1 : value / x
}
