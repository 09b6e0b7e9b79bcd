import { BaseSequencer } from 'vitest/node'
import type { TestSpecification } from 'vitest/node'
import { defineConfig } from 'vitest/config'

/** The first test that fails has found the mutant: those that notice most in the shortest time come first. */
const FIRST = [
  'hard/fingerprint',
  'physics/parse',
  'physics/timesteps',
  'physics/forces',
  'physics/paper',
  'physics/trace',
  'physics/exactTruth',
  'physics/exactSpring',
  'physics/exactFall',
  'physics/exactTrack',
  'physics/exactLaw',
  'physics/simulate',
  'hard/jumps',
  'hard/frames',
  'hard/extremes',
  'hard/friction',
]

class QuickestFirst extends BaseSequencer {
  override sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const rank = ({ moduleId }: TestSpecification) => {
      const place = FIRST.findIndex((name) => moduleId.endsWith(`tests/${name}.test.ts`))
      return place < 0 ? FIRST.length : place
    }
    return Promise.resolve([...files].sort((a, b) => rank(a) - rank(b)))
  }
}

// The tests that `npm run mutate` asks about each mutant. Left out are those that watch the heap, which need a process
// of their own, those that bundle the sources as they are in the file, without the mutants, and what is not about physics.
export default defineConfig({
  test: {
    include: ['tests/{physics,measure,hard}/**/*.test.ts'],
    exclude: ['tests/physics/allocation.test.ts', 'tests/hard/{badAddress,engines}.test.ts'],
    // Enough to see a mutant, asked of thousands.
    env: { FUZZ_RUNS: '300' },
    sequence: { sequencer: QuickestFirst },
    testTimeout: 60_000,
  },
})
