import { withoutRounding } from './rounding.ts'

/** What a run costs, and the error that this buys [m]. */
export interface Offer {
  readonly cost: number
  readonly error: number
}

/**
 * The offers that no other beats, from the cheapest on: whoever pays less has a larger error. Errors that are rounding
 * are all the same; an error or a cost that is not finite beats nothing.
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

/** The cheapest offer with an error no larger than what is tolerated, rounding aside, if there is one. */
export function cheapest<O extends Offer>(
  offers: readonly O[],
  tolerance: number,
  scale = 1,
): O | undefined {
  return frontier(offers, scale).find(({ error }) => withoutRounding(error, scale) <= tolerance)
}
