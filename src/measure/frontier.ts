import { ROUNDING } from './error.ts'

/** What a run costs, and the error that this buys [m]. */
export interface Offer {
  readonly cost: number
  readonly error: number
}

/**
 * The offers that no other beats, from the cheapest on: whoever pays less has a larger error. Errors that are rounding
 * are all the same.
 */
export function frontier<O extends Offer>(offers: readonly O[]): O[] {
  const best: O[] = []
  let least = Infinity
  for (const offer of [...offers].sort((a, b) => a.cost - b.cost || a.error - b.error)) {
    const error = Math.max(offer.error, ROUNDING)
    if (error >= least) continue
    least = error
    best.push(offer)
  }
  return best
}

/** The cheapest offer with an error no larger than what is tolerated, if there is one. */
export function cheapest<O extends Offer>(offers: readonly O[], tolerance: number): O | undefined {
  return frontier(offers).find(({ error }) => Math.max(error, ROUNDING) <= tolerance)
}
