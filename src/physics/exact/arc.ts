import type { Piece } from '../track.ts'
import { DEGREE, crossing, evaluate } from './phase.ts'
import type { Phase } from './phase.ts'
import { slideStraight } from './straight.ts'

// The last terms of the speed's series stay below this part of its first: truncation is below rounding.
const SMALLEST_TERM = 2 ** -60
// The longest step in units of time in which the law turns by about a radian. Held under a half-swing, π of them, so
// that a step holds one stop at most; reached where the series ends early.
const LONGEST = 2

// Series of speed, and of sine and cosine of the slope, in the phase's unit of time.
const speeds = new Float64Array(DEGREE)
const sines = new Float64Array(DEGREE)
const cosines = new Float64Array(DEGREE)

/**
 * A slide on an arc, for one step, or up to a stop or the piece's end where that comes first:
 * s″ = g sin φ − μ (g cos φ + κ s′²), φ = slope − κ (s − at), by Taylor's series of s, whose coefficients follow one
 * from the other (Moore, Interval Analysis, 1966; Jorba & Zou, Experimental Mathematics 14, 2005, for the step).
 *
 * @param v speed at the start [m/s]; where it is 0, the acceleration points along `slip`
 * @param mu coefficient of kinetic friction with the sign of `slip`
 */
export function slideArc(
  phase: Phase,
  s: number,
  v: number,
  slip: 1 | -1,
  mu: number,
  gravity: number,
  piece: Piece,
): void {
  const { c, end } = phase
  const { curvature } = piece
  // The law changes with the angle, which gravity, speed and friction turn; in this unit coefficients stay near 1/κ.
  const size = 1 + Math.abs(mu)
  const rate = Math.sqrt(gravity * size) * Math.sqrt(curvature) + curvature * size * Math.abs(v)
  const unit = Math.min(1 / rate, Number.MAX_VALUE)
  expand(v * unit, mu, gravity * unit * unit, piece.slope - curvature * (s - piece.at), curvature)
  const border = slip > 0 ? piece.to : piece.from
  // No force, nor a change of one: there is none, or one below the smallest number. No step would be the last.
  if (speeds[1] === 0 && speeds[2] === 0) return slideStraight(phase, s, v, slip, 0, border)

  c[0] = s
  for (let n = 1; n <= DEGREE; n++) c[n] = speeds[n - 1]! / n
  phase.unit = unit
  phase.degree = DEGREE

  let x = stepLength()
  const turns = slip * evaluate(speeds, 0, DEGREE - 1, x, end).s <= 0
  // From the far end: where the step starts from v = 0, that is not the one that is meant.
  if (turns) x = crossing(speeds, DEGREE - 1, 0, x)
  evaluate(c, 0, DEGREE, x, end)
  end.v = turns ? 0 : end.v / unit

  if (slip * (end.s - border) > 0) {
    x = crossing(c, DEGREE, border, x)
    evaluate(c, 0, DEGREE, x, end)
    end.s = border
    end.v = slip * Math.max(0, (slip * end.v) / unit)
  }
  phase.lasts = x * unit
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
    const press = gravity * cosines[n]! + curvature * square
    speeds[n + 1] = (gravity * sines[n]! - mu * press) / (n + 1)
    sines[n + 1] = (-curvature * sine) / (n + 1)
    cosines[n + 1] = (curvature * cosine) / (n + 1)
  }
}

/** How far the series can be trusted. Two terms are asked, since every other may vanish by symmetry. */
function stepLength(): number {
  const small = SMALLEST_TERM * Math.max(Math.abs(speeds[0]!), Math.abs(speeds[1]!))
  let x = LONGEST
  for (let n = DEGREE - 2; n < DEGREE; n++) {
    const size = Math.abs(speeds[n]!)
    if (size * x ** n > small) x = (small / size) ** (1 / n)
  }
  return x
}
