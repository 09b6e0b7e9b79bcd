// Each product, and the difference, has a rounding error of at most half an ulp.
const ROUNDING = 4 * Number.EPSILON

/**
 * Whether static friction holds a block at rest: |drive| ≤ μs press (Coulomb, 1785). A tie holds, and so does an
 * excess that is no more than the rounding of the terms that were added up.
 *
 * @param drive the tangential acceleration without friction [m/s²]
 * @param most the largest drive that static friction can hold, μs press [m/s²]
 * @param terms the sum of the sizes of the terms of `drive` [m/s²]
 */
export function frictionHolds(drive: number, most: number, terms: number): boolean {
  return Math.abs(drive) - most <= ROUNDING * (terms + most)
}
