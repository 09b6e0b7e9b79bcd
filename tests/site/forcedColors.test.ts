import { PNG } from 'pngjs'
import type { Locator, Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import { some } from '../samples.ts'
import { openPage } from './page.ts'

/* The page in the colours that the system forces on it. */

async function openForced(colorScheme: 'light' | 'dark', path = ''): Promise<Page> {
  const { page } = await openPage({ width: 1280, height: 1000, path, colorScheme })
  await page.emulateMedia({ forcedColors: 'active', colorScheme })
  return page
}

/** The background of each thing that matches, or of what is drawn after it. */
function backgrounds(page: Page, selector: string, pseudo?: string): Promise<string[]> {
  return page
    .locator(selector)
    .evaluateAll(
      (all, after) => all.map((each) => getComputedStyle(each, after).backgroundColor),
      pseudo,
    )
}

// The system's colours replace those of either theme.
describe.each(some(['light', 'dark'] as const, 1))('in forced colours, %s', (colorScheme) => {
  test('what is chosen has a background that nothing else beside it has', async () => {
    const page = await openForced(colorScheme)
    await page.locator('.measures').scrollIntoViewIfNeeded()
    await page.locator('slide-measure-views > .segments button').first().waitFor()
    await page.locator('#stopping').scrollIntoViewIfNeeded()
    const figure = '#stopping slide-figure:has(.options)'
    await page.locator(`${figure} .options`).first().waitFor()
    await page.locator('.contents [aria-current]').waitFor()
    const groups = [
      ['slide-lab .modes .segments button', "[aria-pressed='true']"],
      ['slide-measure-views > .segments button', "[aria-pressed='true']"],
      [`${figure} .options label`, ':has(:checked)'],
      ['.contents li a', '[aria-current]'],
      ['.take-home [role=tab]', "[aria-selected='true']"],
    ] as const
    for (const [each, chosen] of groups) {
      const [of] = await backgrounds(page, `${each}${chosen}`)
      const others = await backgrounds(page, `${each}:not(${chosen})`)
      expect(others.length, each).toBeGreaterThan(0)
      expect(of, each).toBeDefined()
      expect(others, each).not.toContain(of)
    }
    // The line below the tab of the scene.
    const [line] = await backgrounds(page, '.scenes label:has(:checked)', '::after')
    const [tab] = await backgrounds(page, '.scenes label:has(:checked)')
    expect(line).not.toBe(tab)
  })

  test('sliders have rails', async () => {
    const page = await openForced(colorScheme)
    const slider = page.locator('.quantities input[type=range]')
    const { share } = await drawn(slider.first(), ({ height }) => [height / 2, height / 2 + 1])
    expect(share).toBeGreaterThan(0.9)
  })

  test('the picture stands on the system’s colour, and its blocks can be seen on it', async () => {
    const page = await openForced(colorScheme)
    const canvas = colorScheme === 'light' ? 255 : 0
    const stage = page.locator('slide-stage')
    await expect
      .poll(async () => (await drawn(stage, ({ height }) => [height - 6, height - 5])).common)
      .toEqual([canvas, canvas, canvas])
    const { colours } = await drawn(stage, ({ height }) => [0, height])
    // Three blocks of three colours, each at 4.5:1 or better.
    const hues = colours.filter(([r, g, b]) => Math.max(r, g, b) - Math.min(r, g, b) > 60)
    expect(hues.length).toBeGreaterThanOrEqual(3)
  })

  test('the theme that the reader chose on the page changes nothing', async () => {
    const page = await openForced(colorScheme)
    const before = await page.locator('slide-stage').screenshot()
    await page.evaluate(
      (theme) => (document.documentElement.dataset.theme = theme),
      ['light', 'dark'].find((theme) => theme !== colorScheme)!,
    )
    await page.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    )
    expect(before.equals(await page.locator('slide-stage').screenshot())).toBe(true)
  })
})

type Rgb = readonly [number, number, number]

/**
 * What is drawn in some rows of an element: the commonest colour, the share of columns that are not all of the colour in the
 * element's corner, and every colour that fills more than a hundred pixels.
 */
async function drawn(element: Locator, rowsOf: (size: { height: number }) => number[]) {
  const { width, height, data } = PNG.sync.read(await element.screenshot())
  const [from, to] = rowsOf({ height }).map(Math.floor) as [number, number]
  const at = (x: number, y: number): Rgb =>
    [0, 1, 2].map((i) => data[4 * (y * width + x) + i]!) as unknown as Rgb
  const corner = at(1, 1).join()
  const counts = new Map<string, number>()
  let columns = 0
  for (let x = 0; x < width; x++) {
    let isEmpty = true
    for (let y = from; y < to; y++) {
      const colour = at(x, y).join()
      counts.set(colour, (counts.get(colour) ?? 0) + 1)
      isEmpty &&= colour === corner
    }
    if (!isEmpty) columns++
  }
  const sorted = [...counts].sort(([, a], [, b]) => b - a)
  const parsed = (text: string) => text.split(',').map(Number) as unknown as Rgb
  return {
    share: columns / width,
    common: parsed(sorted[0]![0]),
    colours: sorted.filter(([, count]) => count > 100).map(([text]) => parsed(text)),
  }
}
