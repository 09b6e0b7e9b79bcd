import type { Route } from 'playwright-core'
import { expect, inject, test } from 'vitest'
import { openPage } from './page.ts'

const TILT = '[data-handle="tilt"]'

test('the first drag is answered by what the page itself names: nothing that comes later is waited for', async () => {
  const { page, problems } = await openPage({ path: '404.html' })
  const html = await (await page.request.get(inject('address'))).text()
  const waiting: Route[] = []
  await page.route(/\.js$/, (route) => {
    const isNamed = html.includes(route.request().url().replace(/.*\//, ''))
    if (isNamed) void route.continue()
    else waiting.push(route)
  })
  await page.goto(inject('address'), { waitUntil: 'commit' })
  const spread = page.locator('.spread output')
  await page.locator(TILT).waitFor()
  const before = await spread.innerText()
  const { x, y, width, height } = (await page.locator(TILT).boundingBox())!
  await page.mouse.move(x + width / 2, y + height / 2)
  await page.mouse.down()
  await page.mouse.move(x + width / 2, y + height / 2 - 60)
  await page.mouse.up()
  await expect.poll(() => spread.innerText()).not.toBe(before)
  expect(waiting.length).toBeGreaterThan(0)
  for (const route of waiting) await route.continue()
  expect(problems).toEqual([])
})
