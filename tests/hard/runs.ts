/** How often the properties are tried, and from which seed. */
import fc from 'fast-check'
import type { Arbitrary } from 'fast-check'
import { samples } from '../samples.ts'

/** Whether this is `npm run fuzz`: a million runs, or as many as FUZZ_RUNS says. */
export const FUZZES = process.env.npm_lifecycle_event === 'fuzz'
const RUNS = Number(process.env.FUZZ_RUNS ?? (FUZZES ? 1_000_000 : samples(2000, 100_000)))
const SEED = Number(process.env.FUZZ_SEED ?? 20_220_704)

/**
 * Tries a property on its share of all runs. What fails is shown with its seed and path, which fast-check replays, and
 * shrunk to the plainest experiment that still fails.
 */
export function check<T>(share: number, from: Arbitrary<T>, property: (value: T) => void): void {
  const numRuns = Math.round(share * RUNS)
  console.log(`${numRuns} runs, seed ${SEED}`)
  fc.assert(fc.property(from, property), { numRuns, seed: SEED })
}
