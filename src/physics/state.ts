/** The state of a motion: distance along the track [m] and speed [m/s]. */
export interface State {
  s: number
  v: number
}

/** A motion known at every instant: sets `into` to the state at the time t ≥ 0 [s] and returns it. */
export type ExactMotion = (t: number, into: State) => State

/** A point of a track, in a frame with x to the right and y upwards [m]. */
export interface Place {
  x: number
  y: number
  /** The direction of growing s, below the horizontal [rad]. */
  slope: number
  /** The curvature, −dslope/ds: positive where the track bends upwards [1/m]. */
  curvature: number
}

export type Parameters = Readonly<Record<string, number>>
