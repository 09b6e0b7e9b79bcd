/** How often the properties are tried, and from which seed. */
import fc from 'fast-check'
import type { Arbitrary } from 'fast-check'
import { samples } from '../samples.ts'

// `npm run fuzz`, by which npm calls it, takes more than any other.
const MOST = process.env.npm_lifecycle_event === 'fuzz' ? 1_000_000 : 100_000
const RUNS = Number(process.env.FUZZ_RUNS ?? samples(1000, MOST))
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
