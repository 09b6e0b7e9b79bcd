import type { Bound } from './hardCase.ts'
import crestAndBelt from './results/crestAndBelt.json'
import edges from './results/edges.json'
import extremes from './results/extremes.json'
import frames from './results/frames.json'
import friction from './results/friction.json'
import jumps from './results/jumps.json'
import limits from './results/limits.json'
import oscillations from './results/oscillations.json'
import tolerances from './results/tolerances.json'

/** The measurement of a claim: of all its runs the one closest to its bound. */
export interface Result {
  /** That run, in words. */
  readonly run: string
  /** How many were measured. */
  readonly runs: number
  readonly value: number
  readonly bound: Bound
}

/** Results by case and claim. */
export type Results = Readonly<Record<string, Readonly<Record<string, Result>>>>

/**
 * What was measured of every claim. `npm run hard-cases` writes these files, and tests compare them with what they
 * measure.
 */
export const hardCaseResults: Results = {
  ...friction,
  ...frames,
  ...oscillations,
  ...extremes,
  ...jumps,
  ...edges,
  ...limits,
  ...crestAndBelt,
  ...tolerances,
}
