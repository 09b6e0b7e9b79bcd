import { expect, test } from 'vitest'
import { some } from '../samples.ts'
import { figures } from '../../src/figures/index.ts'
import { openPage } from './page.ts'

// At these widths of the page; the last figure is another element, which says for itself how much room it takes.
test.each(some([390, 768, 1440], 0, 2))(
  'at %d px a figure that comes alive moves nothing',
  async (width) => {
    const { page, problems } = await openPage({ width })
    const heights = () =>
      page.$$eval('slide-figure', (all) =>
        all.map((each) => [each.getAttribute('name'), (each as HTMLElement).offsetHeight]),
      )
    const before = await heights()
    const names = before.map(([name]) => name)
    expect(new Set(names)).toEqual(new Set(figures.map(({ id }) => id)))
    for (const name of names) {
      const figure = page.locator(`slide-figure[name="${name}"]`)
      await figure.scrollIntoViewIfNeeded()
      await figure.and(page.locator('[live]')).waitFor()
    }
    const own = ([name]: readonly unknown[]) => name !== 'speed-against-error'
    expect((await heights()).filter(own)).toEqual(before.filter(own))
    expect(problems).toEqual([])
  },
)

test('on a phone the outcome keeps clear of the buttons over it', async () => {
  const { page } = await openPage({ width: 390 })
  const figure = page.locator('slide-figure[name="two-become-one"]')
  await figure.scrollIntoViewIfNeeded()
  await figure.and(page.locator('[live]')).waitFor()
  const buttons = (await figure.locator('.options').boundingBox())!
  const says = (await figure.locator('.says').boundingBox())!
  expect(says.y - buttons.y - buttons.height).toBeGreaterThanOrEqual(10)
})

test('before one comes near, nothing of the figures is loaded but their names', async () => {
  const { page, problems } = await openPage({ height: 600 })
  const loaded = () =>
    page.evaluate(() =>
      performance
        .getEntriesByType('resource')
        .map(({ name }) => name.replace(/.*\//, ''))
        .filter((name) => name.endsWith('.js')),
    )
  await page.waitForTimeout(300)
  expect((await loaded()).filter((name) => /^figures-/.test(name))).toEqual([])
  await page.locator('slide-figure[name="paper-step"]').scrollIntoViewIfNeeded()
  await expect
    .poll(async () => (await loaded()).filter((name) => /^figures-/.test(name)))
    .toHaveLength(1)
  expect(problems).toEqual([])
})
