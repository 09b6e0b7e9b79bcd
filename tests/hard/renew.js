/*
 * `npm run hard-cases`: measures the hard cases with every sample, and writes the results that the page shows. Writes
 * nothing when a figure is not within its bound.
 */
import { writeFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import { startVitest } from 'vitest/node'

const root = resolve(import.meta.dirname, '../..')
const files = [
  ...['friction', 'frames', 'oscillations', 'extremes', 'jumps'],
  ...['edges', 'limits', 'crestAndBelt', 'tolerances'],
]

const vitest = await startVitest(
  'test',
  files.map((name) => `tests/hard/${name}.test.ts`),
  { root, config: 'vitest.long.config.ts', project: 'unit', watch: false, reporters: ['dot'] },
)
const tests = vitest.state.getTestModules().flatMap((file) => [...file.children.allTests()])
await vitest.close()

const measured = tests.map((test) => test.meta().hardCases).filter(Boolean)
// The tests that compare the results with those on the page are expected to fail.
const failed = tests.filter((test) => test.result().state === 'failed' && !test.meta().hardCases)
if (failed.length > 0 || measured.length !== files.length) {
  console.log('Nothing is written: see the failed tests above.')
  process.exitCode = 1
} else {
  for (const { name, results } of measured) {
    const path = join(root, `src/measure/hardCases/results/${name}.json`)
    writeFileSync(path, `${JSON.stringify(results, null, 2)}\n`)
    console.log(`Wrote ${path}`)
  }
  process.exitCode = 0
}
