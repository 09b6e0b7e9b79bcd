import { frontier } from '../../measure/index.ts'
import type { Cheapest, Frontier, WorkCurve, WorkPoint } from '../schema/index.ts'

type Cost = 'evaluations' | 'time'

/** Who gets to an error at the lowest cost: ours by evaluations, ours by time, and odex. */
export function compareAt(curves: readonly WorkCurve[], error: number): Frontier['at'][number] {
  const own = curves.filter(({ id }) => id !== 'odex')
  const odex = curves.find(({ id }) => id === 'odex')
  return {
    error,
    fewest: best(own, error, 'evaluations'),
    quickest: best(own, error, 'time'),
    odex: odex ? best([odex], error, 'time') : null,
  }
}

function best(curves: readonly WorkCurve[], error: number, by: Cost): Cheapest | null {
  const offers = curves.flatMap((curve) => {
    const evaluations = costAt(curve.points, error, 'evaluations')
    const time = costAt(curve.points, error, 'time')
    return evaluations === null || time === null
      ? []
      : { id: curve.id, label: curve.label, evaluations, time }
  })
  return offers.sort((a, b) => a[by] - b[by])[0] ?? null
}

/**
 * What an error costs on a curve: between the two neighbouring points of its frontier, on a straight line through their
 * logarithms. Null where the curve does not get there.
 */
export function costAt<By extends Cost>(
  points: readonly Pick<WorkPoint, By | 'error'>[],
  error: number,
  by: By,
): number | null {
  const best = frontier(points.map((point) => ({ cost: point[by], error: point.error })))
  const after = best.findIndex((offer) => offer.error <= error)
  if (after < 0) return null
  const there = best[after]!
  const before = best[after - 1]
  if (!before || there.error <= 0) return there.cost
  const share = Math.log(before.error / error) / Math.log(before.error / there.error)
  return before.cost * (there.cost / before.cost) ** share
}
