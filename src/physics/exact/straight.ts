import type { Phase } from './phase.ts'

/**
 * A slide on a straight, up to a stop or to the piece's end: a parabola. The speed at the end is √(v² + 2ad), by factors
 * that neither cancel nor under- or overflow; the time to the end is the distance over the mean of both speeds.
 *
 * @param v speed at the start [m/s]; where it is 0, `a` points along `slip`
 * @param a acceleration [m/s²]
 * @param to where the piece ends in the direction of `slip` [m], possibly at infinity
 */
export function slideStraight(s: number, v: number, slip: 1 | -1, a: number, to: number): Phase {
  const parabola = { c: [s, v, a / 2], unit: 1 }
  const distance = Math.abs(to - s)
  const speed = Math.abs(v)
  const gain = Math.sqrt(2 * Math.abs(a)) * Math.sqrt(distance)
  const slows = a * slip < 0
  if (slows && speed < gain) {
    const lasts = speed / Math.abs(a)
    const stop = s + (v * lasts) / 2
    const end = { s: slip > 0 ? Math.min(stop, to) : Math.max(stop, to), v: 0 }
    return { ...parabola, lasts, end }
  }
  const endSpeed = slows
    ? Math.sqrt(speed - gain) * Math.sqrt(speed + gain)
    : Math.hypot(speed, gain)
  const lasts = distance === Infinity ? Infinity : (2 * distance) / (speed + endSpeed)
  return { ...parabola, lasts, end: { s: to, v: slip * endSpeed } }
}
