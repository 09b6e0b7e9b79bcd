import type { Experiment } from '../../physics/index.ts'

/** A case on which simulations go wrong: what it is and what to watch. */
export interface HardCase {
  readonly id: string
  /** Cases of one kind share a number, 1 … 28. */
  readonly group: number
  readonly label: string
  /** One sentence about what to look at. */
  readonly watch: string
  /** Runs to be seen side by side, at most eight. */
  readonly experiments: readonly Experiment[]
  /** The experiments are invalid: `parseExperiment` rejects them with the reason. */
  readonly refused?: true
}

/** What the number of a claim counts: metres, seconds, metres a second, joules, a share of the energy, or things. */
export type Unit = 'm' | 's' | 'm/s' | 'J' | 'of the energy' | 'things'

/** A claim about a hard case, with a bound that the tests check. */
export interface Claim {
  /** What is measured, and for which methods, in words that a value can follow. */
  readonly what: string
  /** Where the bound comes from. */
  readonly why: string
  readonly unit: Unit
  /** The bound is a sum of roundings: a value below it is 0 to rounding. */
  readonly rounding?: true
  /** How a method fails here, if it is expected to. */
  readonly failure?: string
}

/** Claims by name. */
export type Claims = Readonly<Record<string, Claim>>

/** The bounds of a measured value: all given ones must hold. */
export interface Bound {
  readonly atMost?: number
  readonly atLeast?: number
  /** It is larger than that. */
  readonly above?: number
}

/** Whether a value is within its bound; NaN never is. */
export function isWithin(value: number, { atMost, atLeast, above }: Bound): boolean {
  return (
    !Number.isNaN(value) &&
    !(atMost !== undefined && value > atMost) &&
    !(atLeast !== undefined && value < atLeast) &&
    !(above !== undefined && value <= above)
  )
}

/** How close a value of 0 or more is to its bound: 0 is far, 1 is at the bound. */
export function nearness(value: number, { atMost, atLeast, above }: Bound): number {
  return Math.max(
    atMost === undefined || value === 0 ? 0 : value / atMost,
    atLeast === undefined ? 0 : atLeast / value,
    above === undefined ? 0 : 1 / (1 + value - above),
  )
}
