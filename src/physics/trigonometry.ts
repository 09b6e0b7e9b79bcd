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
  sin = NaN
  cos = NaN
  reduced = NaN
  tail = NaN

  /** Sets `sin` and `cos` to those of `angle`. Odd and even to the bit: sin −x = −sin x. */
  find(): void {
    const size = Math.abs(this.angle)
    const sign = this.angle < 0 ? -1 : 1
    if (size < Math.PI / 4) {
      this.reduced = size
      this.tail = 0
      this.findReduced()
      this.sin *= sign
    } else if (size < LARGEST) {
      const quarters = Math.round(size * TWO_OVER_PI)
      const rest = size - quarters * HALF_PI_1
      const correction = quarters * HALF_PI_2
      const reduced = rest - correction
      this.reduced = reduced
      this.tail = rest - reduced - correction - quarters * HALF_PI_3
      this.findReduced()
      this.rotate(quarters % 4, sign)
    } else {
      this.sin = 0 * this.angle
      this.cos = 1 + this.sin
    }
  }

  /**
   * Sets `sin` and `cos` to those of `reduced` + `tail`, the first of them at most π/4, the second below its ulp. Taylor's
   * series: the first term left out, x¹⁹/19!, is below a thousandth of an ulp there.
   */
  findReduced(): void {
    const x = this.reduced
    const z = x * x
    const sineTail =
      S3 + z * (S5 + z * (S7 + z * (S9 + z * (S11 + z * (S13 + z * (S15 + z * S17))))))
    this.sin = x + (x * z * sineTail + this.tail * (1 - 0.5 * z))
    const cosineTail = C4 + z * (C6 + z * (C8 + z * (C10 + z * (C12 + z * (C14 + z * C16)))))
    const head = 1 - 0.5 * z
    // What rounding took from `head` comes back in (1 − head) − z/2, which is exact.
    this.cos = head + (1 - head - 0.5 * z + (z * z * cosineTail - x * this.tail))
  }

  /** Turns the angle just found on by that many quarter turns, then mirrors it. */
  private rotate(quarters: number, sign: number): void {
    const { sin, cos } = this
    if (quarters === 0) {
      this.sin = sign * sin
    } else if (quarters === 1) {
      this.sin = sign * cos
      this.cos = -sin
    } else if (quarters === 2) {
      this.sin = sign * -sin
      this.cos = -cos
    } else {
      this.sin = sign * -cos
      this.cos = sin
    }
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
  result.reduced = product
  result.tail = productError(degrees, DEGREE, product) + degrees * DEGREE_REST
  result.findReduced()
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
