import type { Trajectory } from '../physics/index.ts'
import { fixed, metres, place, raw } from '../chart/numbers.ts'
import { errorAt } from './state/simulation.ts'
import type { Simulated } from './state/simulation.ts'

/**
 * How far a run is from the exact block in one of its rows, signed as in the picture: minus is to the left of the exact
 * block, or above it where everything falls.
 */
export function errorText(
  { exact, scene }: Simulated,
  trajectory: Trajectory,
  row: number,
): { text: string; title: string } {
  const error = errorAt(trajectory, exact, row)
  return {
    text: signed(scene.facing * error),
    title: `s − exact(t) = ${raw(error)} m, at t = ${raw(trajectory.time[row]!)} s`,
  }
}

function signed(error: number): string {
  const size = Math.abs(error)
  // Where millimetres say enough, all rows have them, so that points stand under points.
  const text = size >= 0.001 && size < 1000 ? `${fixed(error, 3)}\u2009m` : metres(error)
  return error > 0 && /[1-9]/.test(text) ? `+${text}` : text
}

/** A distance [m] in words and large type: to the centimetre, or where that says nothing to two digits. */
export function lengthText(length: number): string {
  if (!Number.isFinite(length)) return 'without bound'
  return length >= 0.01 && length < 1000 ? place(length) : metres(Number(length.toPrecision(2)))
}
