import type { Trajectory } from '../physics/index.ts'

/**
 * A run on its way from one to another, in the places that are drawn; all else is as in the one it goes to. Both have
 * the same frames; one that ended early stays where it ended.
 *
 * @param part of the way, 0 … 1
 */
export function blend(from: Trajectory, to: Trajectory, part: number): Trajectory {
  return {
    ...to,
    s: between(from.s, to.s, part),
    drawnS: between(from.drawnS, to.drawnS, part),
  }
}

function between(from: Float64Array, to: Float64Array, part: number): Float64Array {
  const last = from.length - 1
  // Two products, not a product of the difference, which may be too large for a number.
  return to.map((goal, row) => (1 - part) * from[Math.min(row, last)]! + part * goal)
}
