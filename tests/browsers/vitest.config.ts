import { resolve } from 'node:path'
import { defineConfig } from 'vitest/config'

/** `npm run test:browsers`: the site in Chromium, Firefox and WebKit. */
export default defineConfig({
  root: resolve(import.meta.dirname, '../..'),
  test: {
    include: ['tests/browsers/**/*.test.ts'],
    globalSetup: resolve(import.meta.dirname, 'setup.ts'),
    // Each file starts three browsers.
    maxWorkers: 1,
    testTimeout: 120_000,
    hookTimeout: 120_000,
    expect: { poll: { timeout: 15_000 } },
    retry: 1,
  },
})
