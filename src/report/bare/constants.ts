/** The lengths of the three Verlet steps of Yoshida’s method, in units of the whole step. */
export const OUTER = 1 / (2 - Math.cbrt(2))
export const INNER = -Math.cbrt(2) * OUTER

/** Two rounding errors of a number of size one: when an implicit equation is solved. */
export const ROUNDING = 2 * Number.EPSILON
