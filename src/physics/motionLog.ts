/** Where a motion notes the state at the end of each step of a row. Each column has room for all that is asked for. */
export interface MotionLog {
  /** How many rows are filled, and how many will be when all steps of the row are taken. */
  readonly rows: number
  end: number
  /** Distance along the track [m] and speed [m/s]. */
  readonly s: Float64Array
  readonly v: Float64Array
  /** Heat that friction has made so far [J]. */
  readonly heat: Float64Array
}
