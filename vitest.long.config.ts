import { mergeConfig } from 'vitest/config'
import config from './vitest.config.ts'

/**
 * `npm run test:long`: the tests of `npm test`, with every sample and every combination that those leave out. Takes an
 * hour, and runs before a release.
 */
export default mergeConfig(config, {
  test: { env: { TEST_LONG: 'yes' }, testTimeout: 3_600_000 },
})
