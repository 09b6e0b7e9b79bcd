/** Where a motion notes the state at the end of each step of a row, and how long the steps are. */
export interface MotionLog {
  /** The last row that is filled. */
  readonly last: number
  /** The lengths of the steps [s], one more than are taken at the most. */
  readonly lengths: Float64Array
  /** Of all of them [s]; Infinity where they are not the same. */
  readonly each: number
  /** Distance along the track [m] and speed [m/s]. */
  readonly s: Float64Array
  readonly v: Float64Array
  /** Heat that friction has made so far [J]. */
  readonly heat: Float64Array
}
