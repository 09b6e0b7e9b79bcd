import { exactMotion } from '../physics/index.ts'
import type { Trajectory } from '../physics/index.ts'

/** The errors of a run against the true motion: one a frame, and their sizes [m]. */
export interface Errors extends ErrorSizes {
  /** Signed, one for each row of the trajectory. */
  readonly each: Float64Array
  /** Signed, that of the last row. */
  readonly atEnd: number
}

/** The largest and the root mean square error of a run [m]. NaN if the true motion is not known. */
export interface ErrorSizes {
  /** The largest in size. */
  readonly largest: number
  /** Root mean square over the frames: an order is fitted to this, since an end point can be right by luck. */
  readonly rms: number
}

/** How far the physics state is from the truth at the state's own time: s − exact(stateTime). */
export function trajectoryErrors(trajectory: Trajectory): Errors {
  return errors(trajectory, trajectory.s, trajectory.stateTime, 1)
}

/**
 * How far what a frame shows is from the truth at the time when it is shown, times the time scale: drawnS − exact(time).
 * A game that measures its frames wrongly shows that here, and not in the error of its trajectory.
 */
export function presentationErrors(trajectory: Trajectory): Errors {
  return errors(trajectory, trajectory.drawnS, trajectory.time, trajectory.experiment.timeScale)
}

/** The sizes of the presentation errors, without allocating a list of them. */
export function presentationErrorSizes(trajectory: Trajectory): ErrorSizes {
  return sizes(trajectory, trajectory.drawnS, trajectory.time, trajectory.experiment.timeScale)
}

function errors(
  trajectory: Trajectory,
  positions: Float64Array,
  times: Float64Array,
  scale: number,
): Errors {
  const each = new Float64Array(positions.length)
  const { largest, rms } = sizes(trajectory, positions, times, scale, each)
  return { each, atEnd: each[each.length - 1]!, largest, rms }
}

function sizes(
  { experiment }: Trajectory,
  positions: Float64Array,
  times: Float64Array,
  scale: number,
  each?: Float64Array,
): ErrorSizes {
  const motion = exactMotion(experiment)
  const truth = { s: 0, v: 0 }
  let largest = 0
  let squares = 0
  for (let row = 0; row < positions.length; row++) {
    const error = positions[row]! - motion(scale * times[row]!, truth).s
    largest = Math.max(largest, Math.abs(error))
    squares += error * error
    if (each) each[row] = error
  }
  return { largest, rms: Math.sqrt(squares / positions.length) }
}
