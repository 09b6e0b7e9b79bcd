import { AxeBuilder } from '@axe-core/playwright'
import type { Page } from 'playwright-core'

const TUTORIAL = '.tutorial'

/**
 * What axe finds wrong in the page, or in what selectors name, with the elements. Axe reads every element of a page, of
 * which the tutorial has nine in ten: unless it is asked about, it leaves the page first.
 */
export async function violationsOn(page: Page, ...parts: string[]): Promise<string[][]> {
  await page.evaluate(
    ({ tutorial, parts }) => {
      const text = document.querySelector(tutorial)
      if (!parts.some((part) => document.querySelector(part)?.closest(tutorial))) text?.remove()
    },
    { tutorial: TUTORIAL, parts },
  )
  // Without what passed, and without a second page to put the frames' results together.
  const axe = new AxeBuilder({ page }).setLegacyMode().options({ resultTypes: ['violations'] })
  for (const part of parts) axe.include(part)
  const { violations } = await axe.analyze()
  return violations.map(({ id, help, nodes }) => [id, help, ...nodes.map(({ html }) => html)])
}
