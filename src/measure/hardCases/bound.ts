/** What a measured figure is held to: all that is named must hold. */
export interface Bound {
  readonly atMost?: number
  readonly atLeast?: number
  /** It is larger than that. */
  readonly above?: number
}

/** Whether a figure is within its bound; one that is no number never is. */
export function holds(value: number, { atMost, atLeast, above }: Bound): boolean {
  return (
    !Number.isNaN(value) &&
    !(atMost !== undefined && value > atMost) &&
    !(atLeast !== undefined && value < atLeast) &&
    !(above !== undefined && value <= above)
  )
}

/** How near a figure that holds is to its bound: 1 where it could be no nearer, 0 where it could be no farther. */
export function nearness(value: number, { atMost, atLeast, above }: Bound): number {
  const below = atMost === undefined || value === 0 ? 0 : value / atMost
  const over = [atLeast, above].map((least) => (least && value ? least / value : 0))
  // Of two that are only to be larger than 0, the smaller one is nearer; it stays below the others.
  const tie = above === 0 ? 1 / (1 + value) : 0
  return Math.max(below, ...over, tie)
}
