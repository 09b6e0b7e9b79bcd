/*
 * What the report uses of odex. The package ships the TypeScript that it was made from, which a compiler of today would check
 * along with this project, and find wanting; tsconfig.json leads to this file instead.
 */

/** ODEX: extrapolation of the explicit midpoint rule, of variable order and step (Hairer, Nørsett & Wanner, 1993). */
export class Solver {
  /** @param dimension of the state */
  constructor(dimension: number)
  relativeTolerance: number
  absoluteTolerance: number
  solve(
    /** dy/dx at x and y. */
    derivative: (x: number, y: number[]) => number[],
    from: number,
    start: readonly number[],
    to: number,
    /** Called at the end of every step of its own choice. */
    output?: (step: number, before: number, x: number, y: number[]) => void,
  ): { y: number[]; outcome: number }
}
