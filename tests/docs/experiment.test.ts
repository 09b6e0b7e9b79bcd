import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { format, resolveConfig } from 'prettier'
import { expect, test } from 'vitest'
import { parseExperiment } from '../../src/physics/index.ts'
import { experimentPage } from './experimentPage.ts'

const path = join(import.meta.dirname, '../../docs/experiment.md')

test('docs/experiment.md says of scenes, parameters, methods, policies and clocks what the code says', async () => {
  const text = await format(experimentPage(), { ...(await resolveConfig(path)), filepath: path })
  if (process.env.DOCS === 'renew') writeFileSync(path, text)
  // If this fails: npm run docs
  expect(readFileSync(path, 'utf8')).toBe(text)
})

test('its example is an experiment', () => {
  const [, example] = /```json\n([^]*?)```/.exec(readFileSync(path, 'utf8'))!
  const value: unknown = JSON.parse(example!)
  expect(parseExperiment(value)).toMatchObject(value as object)
})
