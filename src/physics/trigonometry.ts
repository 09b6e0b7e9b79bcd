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

// Beyond this the reduction above loses digits. No angle on a track comes near it: only a step that has
// already diverged asks for more, and any finite answer serves it.
const LARGEST = 1e9

// Taylor's coefficients, ±1/n!.
const S3 = -1 / 6
const S5 = 1 / 120
const S7 = -1 / 5040
const S9 = 1 / 362880
const S11 = -1 / 39916800
const S13 = 1 / 6227020800
const S15 = -1 / 1307674368000
const S17 = 1 / 355687428096000
const C4 = 1 / 24
const C6 = -1 / 720
const C8 = 1 / 40320
const C10 = -1 / 3628800
const C12 = 1 / 479001600
const C14 = -1 / 87178291200
const C16 = 1 / 20922789888000

/**
 * The sine and cosine of one angle: set `angle` [rad], call `find`, read `sin` and `cos`. Numbers stand in fields, since
 * engines box one that is passed to a function or returned from it.
 */
export class SinCos {
  angle = NaN
  /** What is to be added to an angle of π/4 at the most, less than its ulp [rad]. */
  tail = 0
  sin = NaN
  cos = NaN
  /** The angle that `sin` and `cos` are of: asked for again, they are there. */
  private found = NaN

  /**
   * Sets `sin` and `cos` to those of `angle`. Odd and even to the bit: sin −x = −sin x. By Taylor's series, up to π/4: the
   * first term left out, x¹⁹/19!, is below a thousandth of an ulp there.
   */
  find(): void {
    const { angle } = this
    if (angle === this.found) return
    this.found = angle
    let x = Math.abs(angle)
    let tail = this.tail
    let quarters = 0
    if (x > Math.PI / 4) {
      if (!(x < LARGEST)) {
        this.sin = 0 * angle
        this.cos = 1 + this.sin
        return
      }
      quarters = Math.round(x * TWO_OVER_PI)
      const rest = x - quarters * HALF_PI_1
      const correction = quarters * HALF_PI_2
      x = rest - correction
      tail = rest - x - correction - quarters * HALF_PI_3
    }
    const z = x * x
    const sineTail =
      S3 + z * (S5 + z * (S7 + z * (S9 + z * (S11 + z * (S13 + z * (S15 + z * S17))))))
    const sin = x + (x * z * sineTail + tail * (1 - 0.5 * z))
    const cosineTail = C4 + z * (C6 + z * (C8 + z * (C10 + z * (C12 + z * (C14 + z * C16)))))
    const head = 1 - 0.5 * z
    // What rounding took from `head` comes back in (1 − head) − z/2, which is exact.
    const cos = head + (1 - head - 0.5 * z + (z * z * cosineTail - x * tail))
    // A quarter turn on, the sine is what was the cosine.
    const turned = quarters % 4
    const size = turned === 0 ? sin : turned === 1 ? cos : turned === 2 ? -sin : -cos
    this.sin = angle < 0 ? -size : size
    this.cos = turned === 0 ? cos : turned === 1 ? -sin : turned === 2 ? -cos : sin
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
// What rounding took from π/180.
const DEGREE_REST = 2.9486522708701687e-19

/** An angle given in degrees, in radians. */
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
  if (mirrored) [result.sin, result.cos] = [result.cos, result.sin]
  if (angle < 0) result.sin = -result.sin
  return result
}

/** What rounding took from a product of two numbers (Dekker, 1971). */
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
