import type { Experiment } from '../../physics/index.ts'

/** A case on which simulations go wrong: what it is and what to watch. */
export interface HardCase {
  readonly id: string
  /** Cases of one kind share a number, 1 … 28. */
  readonly group: number
  readonly label: string
  /** One sentence for whoever looks at it run. */
  readonly watch: string
  /** Runs to be seen side by side, at most eight. */
  readonly experiments: readonly Experiment[]
  /** Its experiments can't be run, and are refused with the reason. */
  readonly refused?: true
}

/** What the number of a claim counts: metres, seconds, metres a second, joules, a share of the energy, or things. */
export type Unit = 'm' | 's' | 'm/s' | 'J' | 'of the energy' | 'things'

/** Something that holds of a hard case; the tests hold it to a figure. */
export interface Claim {
  /** What is measured, and of which methods, in words that a figure can follow. */
  readonly what: string
  /** Where the bound comes from. */
  readonly why: string
  readonly unit: Unit
  /** The bound is a sum of roundings: what stays below it is 0 but for them. */
  readonly rounding?: true
  /** Of a method that fails here, as it is bound to: how. */
  readonly failure?: string
}

/** Claims by a name of their own. */
export type Claims = Readonly<Record<string, Claim>>

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
