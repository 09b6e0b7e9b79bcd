import type { Place } from './state.ts'
import { sinCos, radians, sinCosDegrees } from './trigonometry.ts'

/** A piece of track of constant curvature, between two distances along the track [m]. */
export interface Piece {
  readonly from: number
  readonly to: number
  /** The distance along the track at which `x`, `y` and `slope` are given [m]. */
  readonly at: number
  /** The point there [m]. */
  readonly x: number
  readonly y: number
  /** The direction there, below the horizontal [rad], and its sine and cosine. */
  readonly slope: number
  readonly sin: number
  readonly cos: number
  /** −dslope/ds: 0 on a straight, 1/radius where the track bends upwards [1/m]. */
  readonly curvature: number
}

/** A track: its pieces in order. A block can leave it at an outer end that is at a finite distance. */
export type Track = readonly Piece[]

/** A straight piece through the origin at s = 0, `angle` degrees below the horizontal, up to the distance `to`. */
export function straight(angle: number, to = Infinity): Piece {
  const { sin, cos } = sinCosDegrees(angle)
  return { from: -Infinity, to, at: 0, x: 0, y: 0, slope: radians(angle), sin, cos, curvature: 0 }
}

/** The arc that continues a straight piece from its end, up to the distance `to`. */
export function arcAfter(before: Piece, curvature: number, to: number): Piece {
  const { x, y } = pointOn(before, before.to)
  return { ...before, from: before.to, to, at: before.to, x, y, curvature }
}

/** The endless straight piece that follows an arc, `angle` degrees below the horizontal. */
export function straightAfter(before: Piece, angle: number): Piece {
  const { x, y } = pointOn(before, before.to)
  return { ...straight(angle), from: before.to, at: before.to, x, y }
}

/** The point of a track at the distance `s` [m]. Beyond its ends the outermost pieces continue. */
export function placeOn(track: Track, s: number): Place {
  let i = 0
  while (i < track.length - 1 && !(s <= track[i]!.to)) i++
  const piece = track[i]!
  const { slope, curvature, at } = piece
  return { ...pointOn(piece, s), slope: slope - curvature * (s - at), curvature }
}

/** The direction of an arc's chord is the mean of the directions at its ends. */
function pointOn({ at, x, y, slope, sin, cos, curvature }: Piece, s: number) {
  const distance = s - at
  if (curvature === 0) return { x: x + cos * distance, y: y - sin * distance }
  const half = (curvature * distance) / 2
  const chord = (2 * sinCos(half).sin) / curvature
  const direction = sinCos(slope - half)
  return { x: x + chord * direction.cos, y: y - chord * direction.sin }
}
