import type { ExactMotion } from '../state.ts'
import { frictionHolds } from '../holds.ts'
import { straight } from '../track.ts'
import { cardinal, sinCosDegrees } from '../trigonometry.ts'
import { exactTrack } from './track.ts'

/**
 * A block on a slope, held by a spring, with friction: s″ = G − ω²s − σf, G = g sin α, f = μk g cos α. While the slip
 * direction σ is held, with a the acceleration at the start and x = ωt,
 *
 *     s = s₀ + v₀ sin(x)/ω + a (1 − cos x)/ω²,   v = v₀ cos x + a sin(x)/ω
 *
 * written with sin(x)/x, so that no spring gives the parabola. After the first stop every half-swing lasts π/ω and
 * reduces the drive at the stops, F, by 2f (Coulomb, 1785; Den Hartog, Mechanical Vibrations): the stops are a sum in
 * closed form, whatever the time. An error of a few ulps of x remains in late swings.
 */
export function exactSpring(parameters: {
  angle: number
  stiffness: number
  muStatic: number
  muKinetic: number
  gravity: number
  mass: number
  position: number
  speed: number
}): ExactMotion {
  const { angle, stiffness, muStatic, muKinetic, gravity, mass, position, speed } = parameters
  const square = stiffness / mass
  if (square === 0) return exactTrack([straight(angle)], parameters)

  const omega = Math.sqrt(square)
  const { sin, cos } = sinCosDegrees(angle)
  const friction = muKinetic * gravity * cos
  const hold = Math.max(muStatic, muKinetic) * gravity * cos

  const slip = Math.sign(speed)
  const startDrive = gravity * sin - square * position
  const first = startDrive - slip * friction
  const { stop, stopTime } = firstStop(position, Math.abs(speed), slip, first, omega)

  const stopDrive = speed === 0 ? startDrive : gravity * sin - square * stop
  const direction = Math.sign(stopDrive)
  const F = Math.abs(stopDrive)
  const terms = gravity * sin + square * Math.abs(stop)
  const halfSwings = halfSwingsUntilHeld(F, friction, hold, terms)
  const half = Math.PI / omega

  return (t, into) => {
    if (t < stopTime) {
      const x = omega * t
      const risen = t * cardinal(Math.sin(x / 2), x / 2)
      const run = t * cardinal(Math.sin(x), x)
      into.s = position + speed * run + 0.5 * first * risen * risen
      into.v = speed * Math.cos(x) + first * run
      return into
    }
    const since = t - stopTime
    const n = Math.min(halfSwings, Math.floor(since / half))
    // The sum of the swings so far, 2 (±1)ⁿ (F − f − 2fn)/ω² each.
    const even = n % 2 === 0
    const swung = even ? friction * n : F - friction * n
    into.s = stop + (2 * direction * swung) / square
    into.v = 0
    if (n < halfSwings) {
      const r = Math.max(0, since - n * half)
      const x = omega * r
      const a = (even ? direction : -direction) * (F - friction * (2 * n + 1))
      const risen = r * cardinal(Math.sin(x / 2), x / 2)
      into.s += 0.5 * a * risen * risen
      into.v = a * r * cardinal(Math.sin(x), x)
    }
    return into
  }
}

/** Where and when the block first has v = 0, from the amplitude and the offset of its swing. */
function firstStop(position: number, speed: number, slip: number, a: number, omega: number) {
  if (speed === 0) return { stop: position, stopTime: 0 }
  const offset = (-slip * a) / omega
  const amplitude = Math.hypot(speed, offset)
  const way = offset > 0 ? (speed / (amplitude + offset)) * speed : amplitude - offset
  return { stop: position + (slip * way) / omega, stopTime: Math.atan2(speed, offset) / omega }
}

/**
 * The number of half-swings until friction holds a block whose drive is F at the first stop and 2f less at each later
 * one.
 */
function halfSwingsUntilHeld(F: number, friction: number, hold: number, terms: number): number {
  if (frictionHolds(F, hold, terms)) return 0
  const n = Math.ceil((F - hold) / (2 * friction))
  // Where the drive just ties with friction, rounding may have added a half-swing.
  return frictionHolds(F - 2 * friction * (n - 1), hold, terms) ? n - 1 : n
}
