import { availableParallelism } from 'node:os'
import { defineConfig } from 'vitest/config'

export default defineConfig({
  test: {
    // A browser that is waited for leaves time for another: two files at once even where there are only two cores.
    maxWorkers: Math.max(2, availableParallelism() - 1),
    testTimeout: 120_000,
    hookTimeout: 120_000,
    // Of expect.poll: a busy machine takes longer than the second that it has otherwise.
    expect: { poll: { timeout: 15_000 } },
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
          exclude: ['tests/site/**', 'tests/browsers/**', '**/node_modules/**'],
          // Tests that watch the heap call gc(); only a process, not a worker thread, takes the flag.
          pool: 'forks',
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
          // A browser on a machine shared with others fails now and then by itself: what fails twice is a fault, and
          // what needed its second time is printed with "retry x1".
          retry: 1,
        },
      },
    ],
  },
})
