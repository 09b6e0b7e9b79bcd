import { describe, expect, test } from 'vitest'
import { openPage } from './page.ts'

describe('without JavaScript', () => {
  test.each([1280, 320])('text, equations and stills are there at %d px', async (width) => {
    const { page, problems } = await openPage({ javaScriptEnabled: false, width })
    expect(await page.locator('.text > section').count()).toBe(13)
    const equation = page.locator('.equation math').first()
    expect((await equation.boundingBox())!.height).toBeGreaterThan(10)
    const figures = page.locator('slide-figure')
    const count = await figures.count()
    expect(count).toBeGreaterThan(10)
    for (const figure of await figures.all()) {
      const name = await figure.getAttribute('name')
      const still = figure.locator('.still[role="img"] > svg')
      expect(await still.count(), name!).toBe(1)
      const { width: wide, height } = (await still.boundingBox())!
      expect(wide, name!).toBeGreaterThan(0.6 * Math.min(width, 640))
      expect(height, name!).toBeGreaterThan(60)
    }
    const lab = (await page.locator('#lab .still svg').boundingBox())!
    expect(lab.height).toBeGreaterThan(100)
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    // Letters keep nine tenths of their size on a phone, the lab’s four fifths.
    const scales = await page
      .locator('.still svg')
      .evaluateAll((all) => all.map((svg) => svg.clientWidth / Number(svg.getAttribute('width'))))
    expect(Math.min(...scales)).toBeGreaterThan(0.8)
    // Nothing to press that does nothing.
    expect(await page.locator('.tutorial :is(button, input)').count()).toBe(0)
    // The browser says of every script that it did not load it.
    expect(problems.filter((problem) => !/\.js csp$/.test(problem))).toEqual([])
  })

  test('a number that can be dragged is a number', async () => {
    const { page } = await openPage({ javaScriptEnabled: false })
    expect(await page.locator('.dial').first().innerText()).toMatch(/^[−\d.]+$/)
  })
})

test('the lab’s still goes when the lab comes', async () => {
  const { page } = await openPage()
  await page.locator('#lab slide-stage').waitFor()
  expect(await page.locator('#lab > .still').count()).toBe(0)
})

test('on paper there is nothing to press, and ink on white', async () => {
  const { page } = await openPage({ width: 800, colorScheme: 'dark' })
  await page.evaluate(() => {
    document.documentElement.dataset.theme = 'dark'
    dispatchEvent(new Event('beforeprint'))
  })
  await page.emulateMedia({ media: 'print', colorScheme: 'light' })
  expect(await page.locator('button:visible, [role="slider"]:visible').count()).toBe(0)
  expect(await page.locator('.take-home pre:visible').count()).toBe(8)
  const ink = await page
    .locator('.text p')
    .first()
    .evaluate((p) => getComputedStyle(p).color)
  expect(ink).toBe('rgb(29, 33, 39)')
  await page.evaluate(() => dispatchEvent(new Event('afterprint')))
  expect(await page.evaluate(() => document.documentElement.dataset.theme)).toBe('dark')
})
