import { withoutRounding } from './rounding.ts'

/** The cost and the error [m] of a run. */
export interface Offer {
  readonly cost: number
  readonly error: number
}

/**
 * The offers that no other beats, cheapest first: every cheaper one has a larger error. Errors that are rounding
 * count as equal; an offer whose error or cost is not finite beats nothing.
 *
 * @param scale the length of the path [m]
 */
export function frontier<O extends Offer>(offers: readonly O[], scale = 1): O[] {
  const best: O[] = []
  const sound = offers.filter(({ cost, error }) => Number.isFinite(cost) && Number.isFinite(error))
  let least = Infinity
  for (const offer of sound.sort((a, b) => a.cost - b.cost || a.error - b.error)) {
    const error = withoutRounding(offer.error, scale)
    if (error >= least) continue
    least = error
    best.push(offer)
  }
  return best
}

/** The cheapest offer whose error is within the tolerance, rounding aside, if there is one. */
export function cheapest<O extends Offer>(
  offers: readonly O[],
  tolerance: number,
  scale = 1,
): O | undefined {
  return frontier(offers, scale).find(({ error }) => withoutRounding(error, scale) <= tolerance)
}
