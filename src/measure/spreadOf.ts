/** Largest − smallest of some final positions [m]. */
export function spreadOf(positions: readonly number[]): number {
  return Math.max(...positions) - Math.min(...positions)
}
