import { AxeBuilder } from '@axe-core/playwright'
import { expect, test } from 'vitest'
import { openPage } from './page.ts'

test.each(['light', 'dark'] as const)('axe finds nothing in the %s theme', async (colorScheme) => {
  const { page } = await openPage({ colorScheme })
  const { violations } = await new AxeBuilder({ page }).analyze()
  expect(
    violations.map(({ id, help, nodes }) => [id, help, ...nodes.map((node) => node.html)]),
  ).toEqual([])
})
