import { BaseSequencer } from 'vitest/node'
import type { TestSpecification } from 'vitest/node'
import { defineConfig } from 'vitest/config'

/**
 * The tests that `npm run mutate` asks about each mutant, in this order: the first that fails has found it, so those that
 * notice most in the shortest time come first. Left out are tests that find nothing which these do not (orders of
 * convergence, long oscillations, most of tests/measure), that watch the heap, that bundle the sources without
 * mutants, or that take a minute with every mutant in place (exactLong).
 */
const ASKED = [
  'physics/descriptions',
  'physics/formulas',
  'physics/lists',
  'physics/messages',
  'physics/parse',
  'physics/parseUnsafe',
  'physics/vector',
  'physics/holds',
  'physics/damping',
  'physics/diverged',
  'physics/track',
  'physics/laws',
  'physics/runOut',
  'physics/stepCounts',
  'physics/edges',
  'physics/forces',
  'physics/integrators',
  'physics/trigonometry',
  'physics/work',
  'physics/paidRest',
  'physics/stopAtJoint',
  'physics/heat',
  'physics/heatQuadrature',
  'physics/exactTruth',
  'physics/crossing',
  'physics/exactKept',
  'physics/exactFall',
  'physics/exactSpring',
  'physics/exactEdges',
  'physics/exactEnergy',
  'physics/lastFrame',
  'physics/frameArgument',
  'physics/paper',
  'physics/timesteps',
  'physics/clocks',
  'hard/fingerprint',
  'physics/simulate',
  'physics/frameLoop',
  'physics/ties',
  'hard/jumps',
  'hard/friction',
  'physics/trace',
  'physics/eventsInOrder',
  'physics/tolerance',
  'physics/exactAgain',
  'physics/exactTrack',
  'physics/exactLaw',
  'physics/newScenes',
  'physics/truthBends',
  'physics/shortBends',
  'physics/lips',
  'hard/extremes',
  'hard/properties',
  'physics/truth',
]

const rank = ({ moduleId }: TestSpecification) =>
  ASKED.findIndex((name) => moduleId.endsWith(`tests/${name}.test.ts`))

class QuickestFirst extends BaseSequencer {
  override sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    return Promise.resolve([...files].sort((a, b) => rank(a) - rank(b)))
  }
}

export default defineConfig({
  test: {
    include: ASKED.map((name) => `tests/${name}.test.ts`),
    setupFiles: ['tests/mutation/setup.ts'],
    // One worker and one world of modules for all files of a mutant.
    isolate: false,
    // Enough to see a mutant, asked of thousands.
    env: { FUZZ_RUNS: '100', SAMPLES: '0.02' },
    sequence: { sequencer: QuickestFirst },
    testTimeout: 60_000,
  },
})
