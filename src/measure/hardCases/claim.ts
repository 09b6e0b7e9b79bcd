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
