/** Friction and drag at one end of a step, per mass, and their first three derivatives with respect to distance. */
export class Resistance {
  /** For the other end of the step. */
  other: Resistance | undefined
  /** The state at which these hold [m, m/s]; NaN if not yet computed. */
  s = NaN
  v = NaN
  /** [m/s²] */
  force = NaN
  first = NaN
  second = NaN
  third = NaN

  /** A linked pair, for the two ends of a step. */
  static pair(): Resistance {
    const [one, other] = [new Resistance(), new Resistance()]
    one.other = other
    other.other = one
    return one
  }
}
