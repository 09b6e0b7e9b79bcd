/**
 * The power p in error ≈ C · stepᵖ: the slope of the least-squares line through the logarithms.
 *
 * @param steps step lengths, at least two different ones
 * @param errors an error for each, positive; zeros carry no information and are left out
 * @returns NaN where fewer than two errors are left
 */
export function fittedOrder(steps: readonly number[], errors: readonly number[]): number {
  const points = steps
    .map((step, i) => ({ x: Math.log(step), y: Math.log(errors[i]!) }))
    .filter(({ y }) => Number.isFinite(y))
  if (points.length < 2) return NaN
  const meanX = points.reduce((sum, { x }) => sum + x, 0) / points.length
  const meanY = points.reduce((sum, { y }) => sum + y, 0) / points.length
  let covariance = 0
  let variance = 0
  for (const { x, y } of points) {
    covariance += (x - meanX) * (y - meanY)
    variance += (x - meanX) ** 2
  }
  return covariance / variance
}
