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

/** How near a figure of 0 or more that holds is to its bound: from 0 to 1, where it could be no nearer. */
export function nearness(value: number, { atMost, atLeast, above }: Bound): number {
  return Math.max(
    atMost === undefined || value === 0 ? 0 : value / atMost,
    atLeast === undefined ? 0 : atLeast / value,
    above === undefined ? 0 : 1 / (1 + value - above),
  )
}
