import type { Place } from './scene.ts'
import { sinCos, radians, sinCosDegrees } from './trigonometry.ts'

/** A stretch of track of constant curvature, from one distance along it to another [m]. */
export interface Piece {
  readonly from: number
  readonly to: number
  /** A distance along the track at which the rest is given [m]. */
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

/** A track: its pieces in order. Where the first begins and the last ends at a finite distance, a block can leave it. */
export type Track = readonly Piece[]

/** A straight piece through the origin at s = 0, that many degrees below the horizontal, up to the distance `to`. */
export function straight(angle: number, to = Infinity): Piece {
  const { sin, cos } = sinCosDegrees(angle)
  return { from: -Infinity, to, at: 0, x: 0, y: 0, slope: radians(angle), sin, cos, curvature: 0 }
}

/** The point of a track at the distance `s` [m]. Beyond its ends the outermost pieces go on. */
export function placeOn(track: Track, s: number): Place {
  let i = 0
  while (i < track.length - 1 && !(s <= track[i]!.to)) i++
  const piece = track[i]!
  const { at, x, y, slope, sin, cos, curvature } = piece
  const distance = s - at
  if (curvature === 0) return { x: x + cos * distance, y: y - sin * distance, slope, curvature }
  const turned = sinCos(slope - curvature * distance)
  return {
    x: x + (sin - turned.sin) / curvature,
    y: y - (turned.cos - cos) / curvature,
    slope: slope - curvature * distance,
    curvature,
  }
}
