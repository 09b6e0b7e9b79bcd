// Each of the products and the difference that are compared is off by half an ulp at most.
const ROUNDING = 4 * Number.EPSILON

/**
 * Whether static friction holds a block at rest: |drive| ≤ μs press (Coulomb, 1785). A tie holds, and so does an
 * excess that is no more than the rounding of the terms that were added up.
 *
 * @param drive every force along the track but friction, per mass [m/s²]
 * @param most the most that static friction can hold, μs press [m/s²]
 * @param terms the sum of the sizes of the terms of `drive` [m/s²]
 */
export function holds(drive: number, most: number, terms: number): boolean {
  return Math.abs(drive) - most <= ROUNDING * (terms + most)
}
