import type { Piece } from '../track.ts'
import { cardinal } from '../trigonometry.ts'
import { crossing, evaluate, stay } from './phase.ts'
import type { Phase } from './phase.ts'
import { slideStraight } from './straight.ts'

// The degree of the polynomial of s: the cost of a step grows with its square, the step's length more and more slowly.
const DEGREE = 24
// The first omitted term is at most this fraction of the largest: truncation is below rounding.
const TRUNCATION = 2 ** -60
// The step length follows from this coefficient and all later ones. A few are not enough: from rest every other one
// is 0, from rest on a wall three of four are, and near 30° and 60° one of three is small.
const FIRST_BOUND = DEGREE / 2
// The longest step, in the time in which the law turns by about a radian. It is shorter than a half-swing, which takes
// π of these, so that a step contains at most one stop; it applies where the series ends early.
const LONGEST = 2
// Rounding leaves an energy error of some ulps of the energy, and of the work of the force over the whole distance,
// whose ulp is the ulp of s. An error of more ulps than this has another cause.
const MOST_ENERGY_ERROR = 16 * Number.EPSILON

// Series of speed, of sine and cosine of the slope, and of the press, in the phase's unit of time.
const speeds: number[] = []
const sines: number[] = []
const cosines: number[] = []
const press = { s: NaN, v: NaN }
const presses: number[] = []

/**
 * Slides on an arc for one step, or up to a stop, the piece's end or, on a crest, the take-off if that comes first:
 * s″ = g sin φ − μ (g cos φ + κ s′²), φ = slope − κ (s − at), by the Taylor series of s, whose coefficients follow
 * from each other (Moore, Interval Analysis, 1966; Jorba & Zou, Experimental Mathematics 14, 2005, for the step). The
 * phase is refused if the step misses the energy integral by more than rounding.
 *
 * @param v speed at the start [m/s]; where it is 0, the acceleration points along `slip`
 * @param mu coefficient of kinetic friction with the sign of `slip`
 */
export function slideArc(
  s: number,
  v: number,
  slip: 1 | -1,
  mu: number,
  gravity: number,
  piece: Piece,
): Phase {
  const { curvature } = piece
  const slope = piece.slope - curvature * (s - piece.at)
  // The law changes with the angle, which gravity, speed and friction turn; in this unit coefficients stay near 1/κ.
  const size = 1 + Math.abs(mu)
  const bend = Math.abs(curvature)
  const rate = Math.sqrt(gravity * size) * Math.sqrt(bend) + bend * size * Math.abs(v)
  const unit = Math.min(1 / rate, Number.MAX_VALUE)
  // Gravity in it [m].
  const pull = gravity * unit * unit
  expand(v * unit, mu, pull, slope, curvature)
  const border = slip > 0 ? piece.to : piece.from
  // No force, or one that underflows: the series would need endlessly many steps.
  if (speeds[1] === 0 && speeds[2] === 0) return slideStraight(s, v, slip, 0, border)

  // concat allocates no spare capacity, and a motion keeps thousands of these arrays.
  const c = [s].concat(speeds)
  for (let n = 1; n <= DEGREE; n++) c[n]! /= n
  const end = { s: NaN, v: NaN }
  let x = stepLength()
  evaluate(c, x, end)
  // Over the whole step, even if the block stops or leaves within it: truncation is largest at its end.
  if (!keepsEnergy(s, v * unit, end.s, end.v, mu, pull, slope, curvature)) return stay(NaN, NaN)

  const turns = slip * end.v <= 0
  if (turns) {
    // Searched from the far end: a step that starts from v = 0 has another crossing at its start.
    x = crossing(speeds, 0, x)
    evaluate(c, x, end)
  }
  end.v = turns ? 0 : end.v / unit

  if (slip * (end.s - border) > 0) {
    x = crossing(c, border, x)
    evaluate(c, x, end)
    end.s = border
    end.v = slip * Math.max(0, (slip * end.v) / unit)
  }
  // On a crest, press grows up to the top and falls beyond it: its sign at the end shows whether it has been 0.
  const takesOff = curvature < 0 && evaluate(presses, x, press).s < 0
  if (takesOff) {
    x = crossing(presses, 0, x)
    evaluate(c, x, end)
    end.v /= unit
  }
  return { c, unit, lasts: x * unit, end, takesOff }
}

/** Sets the series from speed, gravity and slope φ at the start: (sin φ)′ = −κ v cos φ, (cos φ)′ = κ v sin φ. */
function expand(v: number, mu: number, gravity: number, slope: number, curvature: number): void {
  speeds[0] = v
  sines[0] = Math.sin(slope)
  cosines[0] = Math.cos(slope)
  for (let n = 0; n < DEGREE - 1; n++) {
    let square = 0
    let sine = 0
    let cosine = 0
    for (let k = 0; k <= n; k++) {
      const speed = speeds[k]!
      square += speed * speeds[n - k]!
      sine += speed * cosines[n - k]!
      cosine += speed * sines[n - k]!
    }
    presses[n] = gravity * cosines[n]! + curvature * square
    speeds[n + 1] = (gravity * sines[n]! - mu * presses[n]!) / (n + 1)
    sines[n + 1] = (-curvature * sine) / (n + 1)
    cosines[n + 1] = (curvature * cosine) / (n + 1)
  }
}

/**
 * The step for which the series holds: coefficient n is taken as at most M/rⁿ, with the least r that the later ones
 * allow.
 */
function stepLength(): number {
  const largest = Math.max(Math.abs(speeds[0]!), Math.abs(speeds[1]!))
  let growth = -Infinity
  for (let n = FIRST_BOUND; n < DEGREE; n++)
    growth = Math.max(growth, Math.log(Math.abs(speeds[n]!) / largest) / n)
  return Math.min(LONGEST, Math.exp(Math.log(TRUNCATION) / DEGREE - growth))
}

/**
 * Whether two states on an arc have the same energy, apart from friction's work and rounding. The kinetic energy
 * K = v²/2 obeys dK/ds = g sin φ − μ (g cos φ + 2κK), which is linear. Over a distance d, on which φ turns by −κd:
 *
 *     K₁ = K₀ eᶻ + (g/κ) (F₁ − F₀ eᶻ),   z = −2μκd,   F = (1 − 2μ²)/(1 + 4μ²) cos φ + 3μ/(1 + 4μ²) sin φ
 *
 * written with sin(x)/x and (eᶻ − 1)/z, so that a slight curvature or a short distance loses no digits.
 */
function keepsEnergy(
  s0: number,
  v0: number,
  s1: number,
  v1: number,
  mu: number,
  gravity: number,
  slope: number,
  curvature: number,
): boolean {
  const before = 0.5 * v0 * v0
  const after = 0.5 * v1 * v1
  const distance = s1 - s0
  const halfTurn = -0.5 * curvature * distance
  const middle = slope + halfTurn
  const z = 4 * mu * halfTurn
  const divisor = 1 + 4 * mu * mu
  const a = (1 - 2 * mu * mu) / divisor
  const b = (3 * mu) / divisor
  const change =
    (a * Math.sin(middle) - b * Math.cos(middle)) * cardinal(Math.sin(halfTurn), halfTurn) +
    2 * mu * (a * Math.cos(slope) + b * Math.sin(slope)) * cardinal(Math.expm1(z), z)
  const error = after - before * Math.exp(z) - gravity * distance * change
  const force =
    gravity * (1 + Math.abs(mu)) + 2 * Math.abs(mu * curvature) * Math.max(before, after)
  const size = before + after + force * (Math.abs(s0) + Math.abs(s1))
  return Math.abs(error) <= MOST_ENERGY_ERROR * size
}
