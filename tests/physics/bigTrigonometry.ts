/** Sines and cosines to 70 digits, in whole numbers of any size, to hold floating-point ones against. */

const BITS = 256n
const ONE = 1n << BITS

/** A number in units of 2⁻²⁵⁶. */
export type Fixed = bigint

/** A floating-point number, exactly; denormal tails beyond 2⁻²⁵⁶ are cut off. */
function fixed(x: number): Fixed {
  const view = new DataView(new ArrayBuffer(8))
  view.setFloat64(0, x)
  const bits = view.getBigUint64(0)
  const exponent = Number((bits >> 52n) & 0x7ffn)
  const mantissa = (bits & 0xfffffffffffffn) | (exponent ? 1n << 52n : 0n)
  const shift = BITS + BigInt((exponent || 1) - 1075)
  const size = shift >= 0n ? mantissa << shift : mantissa >> -shift
  return x < 0 ? -size : size
}

/** π by Machin's formula. */
const PI = 4n * (4n * arcTangentOfOneOver(5n) - arcTangentOfOneOver(239n))

function arcTangentOfOneOver(n: bigint): Fixed {
  let power = ONE / n
  let sum = power
  for (let k = 3n; power !== 0n; k += 2n) {
    power /= -n * n
    sum += power / k
  }
  return sum
}

/** An angle in degrees, in radians. */
export function radiansOf(degrees: number): Fixed {
  return (PI * fixed(degrees)) / (180n * ONE)
}

function series(angle: Fixed, first: Fixed, k: bigint): Fixed {
  const square = (angle * angle) >> BITS
  let term = first
  let sum = first
  for (; term !== 0n; k += 2n) {
    term = -((term * square) >> BITS) / (k * (k + 1n))
    sum += term
  }
  return sum
}

export function sineOf(angle: number | Fixed): Fixed {
  const x = typeof angle === 'number' ? fixed(angle) : angle
  return series(x, x, 2n)
}

export function cosineOf(angle: number | Fixed): Fixed {
  return series(typeof angle === 'number' ? fixed(angle) : angle, ONE, 1n)
}

/** How many units in its last place a floating-point number is from the true value. */
export function ulpsBetween(x: number, truth: Fixed): number {
  const exponent = x === 0 ? -1074 : Math.max(-1074, Math.floor(Math.log2(Math.abs(x))) - 52)
  const ulp = exponent + 256 >= 0 ? 1n << BigInt(exponent + 256) : 1n
  const difference = fixed(x) - truth
  return Number(difference < 0n ? -difference : difference) / Number(ulp)
}
