import type { Phase } from './phase.ts'

/**
 * A slide on a straight, up to a stop or to the piece's end: a parabola. The speed at the end is √(v² + 2ad), by factors
 * that neither cancel nor under- or overflow, and the time to it the distance over the mean of both speeds.
 *
 * @param v speed at the start [m/s]; where it is 0, `a` points along `slip`
 * @param a acceleration [m/s²]
 * @param end where the piece ends in the direction of `slip` [m], maybe at infinity
 */
export function slideStraight(
  phase: Phase,
  s: number,
  v: number,
  slip: 1 | -1,
  a: number,
  end: number,
): void {
  phase.unit = 1
  phase.degree = 2
  phase.c[0] = s
  phase.c[1] = v
  phase.c[2] = a / 2
  const distance = Math.abs(end - s)
  const speed = Math.abs(v)
  const gain = Math.sqrt(2 * Math.abs(a)) * Math.sqrt(distance)
  const slows = a * slip < 0
  if (slows && speed < gain) {
    phase.lasts = speed / Math.abs(a)
    const stop = s + (v * phase.lasts) / 2
    phase.end.s = slip > 0 ? Math.min(stop, end) : Math.max(stop, end)
    phase.end.v = 0
  } else if (distance === Infinity) {
    phase.lasts = Infinity
  } else {
    const endSpeed = slows
      ? Math.sqrt(speed - gain) * Math.sqrt(speed + gain)
      : Math.hypot(speed, gain)
    phase.lasts = (2 * distance) / (speed + endSpeed)
    phase.end.s = end
    phase.end.v = slip * endSpeed
  }
}
