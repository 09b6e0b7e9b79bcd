import { availableParallelism } from 'node:os'
import { defineConfig } from 'vitest/config'

/** Tests that watch the heap call gc(), and what other tests have run in their process would count. */
const heap = ['physics/allocation', 'physics/exactKept', 'report/timing'].map(
  (name) => `tests/${name}.test.ts`,
)

export default defineConfig({
  test: {
    pool: 'forks',
    // Tests of pages mostly wait for the browser: one file more than there are cores keeps these busy.
    maxWorkers: availableParallelism() + 1,
    // They only end what hangs: no test depends on how busy the machine is.
    testTimeout: 300_000,
    hookTimeout: 300_000,
    expect: { poll: { timeout: 30_000 } },
    coverage: {
      provider: 'v8',
      include: ['src/physics/**/*.ts'],
      reporter: ['text'],
      reportsDirectory: 'node_modules/.cache/coverage',
      thresholds: { lines: 100, branches: 100 },
    },
    projects: [
      {
        extends: true,
        test: {
          name: 'unit',
          include: ['tests/**/*.test.ts'],
          exclude: [...heap, 'tests/site/**', 'tests/browsers/**', '**/node_modules/**'],
          // One world of modules for all files of a worker: reading them anew took a quarter of the time.
          isolate: false,
        },
      },
      {
        extends: true,
        test: {
          name: 'heap',
          include: heap,
          // A young generation of 64 MB, so that what a million steps allocate is not collected before it is counted.
          execArgv: ['--expose-gc', '--min-semi-space-size=64', '--max-semi-space-size=64'],
        },
      },
      {
        extends: true,
        test: {
          name: 'site',
          include: ['tests/site/**/*.test.ts'],
          globalSetup: 'tests/site/setup.ts',
          // Nothing but the connection to the browser is kept from file to file, and Playwright is loaded once.
          isolate: false,
        },
      },
    ],
  },
})
