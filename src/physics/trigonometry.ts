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

/** The sine and cosine of one angle; `of` sets both. Results stand in fields, since a returned number may be boxed. */
export class SinCos {
  sin = 0.5
  cos = 0.5

  /** Sets `sin` and `cos` to those of an angle [rad]. Odd and even to the bit: sin −x = −sin x. */
  of(angle: number): void {
    const size = Math.abs(angle)
    const sign = angle < 0 ? -1 : 1
    if (size < Math.PI / 4) {
      this.near(size, 0)
      this.sin *= sign
    } else if (size < LARGEST) {
      const turns = Math.round(size * TWO_OVER_PI)
      const rest = size - turns * HALF_PI_1
      const correction = turns * HALF_PI_2
      const reduced = rest - correction
      this.near(reduced, rest - reduced - correction - turns * HALF_PI_3)
      this.rotate(turns % 4, sign)
    } else {
      this.sin = angle === angle ? 0 : NaN
      this.cos = angle === angle ? 1 : NaN
    }
  }

  /**
   * Sets `sin` and `cos` to those of x + tail, |x| ≤ π/4 and the tail below an ulp of x. Taylor's series: the
   * first term left out, x¹⁹/19!, is below 2⁻⁵³/1000 of the sum there.
   */
  near(x: number, tail: number): void {
    const z = x * x
    this.sin =
      x +
      (x *
        z *
        (-1 / 6 +
          z *
            (1 / 120 +
              z *
                (-1 / 5040 +
                  z *
                    (1 / 362880 +
                      z *
                        (-1 / 39916800 +
                          z *
                            (1 / 6227020800 + z * (-1 / 1307674368000 + z / 355687428096000))))))) +
        tail * (1 - 0.5 * z))
    const head = 1 - 0.5 * z
    // What rounding took from `head` comes back in (1 − head) − z/2, which is exact.
    this.cos =
      head +
      (1 -
        head -
        0.5 * z +
        (z *
          z *
          (1 / 24 +
            z *
              (-1 / 720 +
                z *
                  (1 / 40320 +
                    z *
                      (-1 / 3628800 +
                        z * (1 / 479001600 + z * (-1 / 87178291200 + z / 20922789888000)))))) -
          x * tail))
  }

  /** Turns the angle found by `near` on by that many quarter turns, then mirrors it. */
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
  result.near(product, productError(degrees, DEGREE, product) + degrees * DEGREE_REST)
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
