import { expect, test } from 'vitest'
import { sweepMethods } from '../../src/measure/index.ts'
import { some } from '../samples.ts'
import { openPage } from './page.ts'
import { holdWorkers, openMeasures } from './measurePage.ts'

const places = [
  { width: 1440, hasTouch: false },
  { width: 768, hasTouch: false },
  { width: 768, hasTouch: true },
  { width: 390, hasTouch: true },
  { width: 390, hasTouch: false },
]

// As many lines of advice as there can be, and what leaves the track; one line; a map with theory's line.
const addresses = ['scene=half-pipe&runners=10;30;120', 'scene=ramp', 'scene=spring']

test.each(
  some(
    addresses.flatMap((address) => places.map((place) => ({ ...place, address }))),
    // All views on a phone, where there is least room, and one line of advice on a wide screen.
    ...[3, 5],
  ),
)(
  'at $width px (touch: $hasTouch) measuring moves nothing below $address',
  async ({ width, hasTouch, address }) => {
    const lab = await openMeasures(address, { width, hasTouch, prepare: holdWorkers })
    const { page } = lab
    const views = ['Speed against error', 'Frame-rate map', 'Frame-rate spread']
    for (const view of address.includes('half-pipe') ? [...views, 'Time on this device'] : views) {
      await page.evaluate(() => (window as unknown as { hold: () => void }).hold())
      if (view === 'Time on this device') await lab.view(views[0]!)
      if (view !== views[0]) await lab.view(view)
      await page.getByRole('progressbar', { name: 'Measuring' }).waitFor()
      const before = await page.evaluate(() => {
        const places = new Set<number>()
        Object.assign(window, { places })
        const measures = document.querySelector('slide-lab-measures')!
        const look = () => {
          const { top } = measures.nextElementSibling!.getBoundingClientRect()
          places.add(Math.round(10 * (top + scrollY)) / 10)
        }
        new ResizeObserver(look).observe(measures.firstElementChild!)
        look()
        return [...places]
      })
      await page.evaluate(() => (window as unknown as { letGo: () => void }).letGo())
      // Errors are measured before times are.
      if (view === 'Time on this device')
        await expect
          .poll(() => page.locator('slide-speed-diagram .curve').count(), { timeout: 20_000 })
          .toBe(2 * sweepMethods.length)
      await lab.ready()
      await page.locator('slide-lab-measures .measure:not([data-busy])').waitFor()
      const after = await page.evaluate(() => [
        ...(window as unknown as { places: Set<number> }).places,
      ])
      expect(after, view).toEqual(before)
    }
    expect(lab.problems).toEqual([])
  },
)

test.each([1440, 390])('at %i px the text’s own diagram keeps its height too', async (width) => {
  const { page, problems } = await openPage({ width, hasTouch: width < 800 })
  await page.evaluate(holdWorkers)
  const figure = page.locator('slide-figure[name="speed-against-error"]')
  const bar = figure.getByRole('progressbar', { name: 'Measuring' })
  // What comes alive above it on the way may push it out of sight.
  await expect
    .poll(async () => {
      await figure.evaluate((each) => each.scrollIntoView())
      return bar.count()
    })
    .toBe(1)
  const before = await figure.evaluate((each) => {
    const heights = new Set<number>()
    Object.assign(window, { heights })
    const look = () => heights.add((each as HTMLElement).offsetHeight)
    new ResizeObserver(look).observe(each)
    look()
    return [...heights]
  })
  await page.evaluate(() => (window as unknown as { letGo: () => void }).letGo())
  await expect
    .poll(
      async () => {
        await figure.evaluate((each) => each.scrollIntoView())
        return figure.locator('.curve').count()
      },
      { timeout: 20_000 },
    )
    .toBe(2 * sweepMethods.length)
  await expect.poll(() => bar.count()).toBe(0)
  expect(await figure.locator('.advice li').count()).toBeGreaterThan(3)
  const after = await page.evaluate(() => [
    ...(window as unknown as { heights: Set<number> }).heights,
  ])
  expect(after).toEqual(before)
  expect(problems).toEqual([])
})
