import { expect, test } from 'vitest'
import { experimentOf } from '../../src/lab/state/check.ts'
import { opening } from '../../src/lab/state/opening.ts'
import { exact, simulate } from '../../src/physics/index.ts'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { outOfSight } from './frames.ts'
import { openLab } from './labPage.ts'
import { at, openPlots } from './plotsPage.ts'

const runs = opening.runners.map((runner) => simulate(experimentOf(opening, runner)))
const truth = (time: number) => exact(experimentOf(opening, opening.runners[0]!), time)
const CURSOR = 'canvas.cursor'
const CHART = 'canvas.chart'

test('plots are drawn when they come near, in a box that was as high before', async () => {
  const lab = await openLab('', { height: 400 })
  const { page } = lab
  const heights = () =>
    page
      .locator('slide-lab-plot')
      .evaluateAll((all) => all.map((each) => (each as HTMLElement).offsetHeight))
  const before = await heights()
  expect(before).toHaveLength(6)
  expect(Math.min(...before)).toBeGreaterThan(250)
  expect(await page.locator('slide-lab-plot canvas').count()).toBe(0)
  await page.locator('slide-lab-plots').evaluate((each) => each.scrollIntoView())
  await expect.poll(() => page.locator('slide-lab-plot canvas.chart').count()).toBe(6)
  expect(await heights()).toEqual(before)
  expect(lab.problems).toEqual([])
})

test('what is plotted is what simulate gives, and follows a change', async () => {
  const lab = await openPlots()
  const check = async (
    id: string,
    values: (run: (typeof runs)[number]) => Float64Array,
    all = runs,
  ) => {
    const curves = await lab.drawing(id)
    all.forEach((run, paletteIndex) => {
      const { x, y, time } = curves.find((each) => each.paletteIndex === paletteIndex)!
      expect(y.length).toBeGreaterThan(7)
      x.forEach((_, i) => {
        const row = run.time.indexOf(time[i]!)
        expect(row).toBeGreaterThanOrEqual(0)
        expect(y[i]).toBe(values(run)[row])
      })
    })
  }
  await check('position', ({ drawnS }) => drawnS)
  await check('speed', ({ v }) => v)
  await check('phase', ({ v }) => v)
  const before = await lab.pixelsOf('position', CHART)
  await lab.page.evaluate(() => {
    const lab = document.querySelector('slide-lab') as unknown as {
      change: (change: object) => void
    }
    lab.change({ kind: 'parameters', values: { angle: 25 } })
  })
  await expect.poll(() => lab.pixelsOf('position', CHART)).not.toBe(before)
  const state = { ...opening, parameters: { ...opening.parameters, angle: 25 } }
  await check(
    'position',
    ({ drawnS }) => drawnS,
    state.runners.map((runner) => simulate(experimentOf(state, runner))),
  )
  expect(lab.problems).toEqual([])
})

test('the cursor is that of the transport', async () => {
  const lab = await openPlots()
  expect(await lab.values('position')).toEqual([
    '−1.47\u202fm',
    '−1.64\u202fm',
    '−1.70\u202fm',
    '−1.72\u202fm',
  ])
  const cursor = await lab.pixelsOf('position', CURSOR)
  const chart = await lab.pixelsOf('position', CHART)
  await lab.time().evaluate((slider: HTMLInputElement) => {
    slider.value = '0.5'
    slider.dispatchEvent(new Event('input', { bubbles: true }))
  })
  await expect
    .poll(() => lab.values('position'))
    .toEqual([
      '−1.41\u202fm',
      ...[1, 2].map((i) => `−${Math.abs(runs[i]!.drawnS[i === 1 ? 15 : 60]!).toFixed(2)}\u202fm`),
      `−${Math.abs(truth(0.5).s).toFixed(2)}\u202fm`,
    ])
  expect(await lab.page.locator('.instant').innerText()).toBe('values at 0.500\u202fs')
  expect(await lab.pixelsOf('position', CURSOR)).not.toBe(cursor)
  // Only the cursor moved: the curves were not drawn again.
  expect(await lab.pixelsOf('position', CHART)).toBe(chart)
})

test('pointing at a plot shows every value of that time in all plots, and moves nothing', async () => {
  const lab = await openPlots()
  const { page } = lab
  const box = () => lab.plot('error').boundingBox()
  const before = await box()
  const { x, y } = await at(page, 'position', 0.25)
  await page.mouse.move(x, y)
  await expect
    .poll(() => page.locator('.instant').innerText())
    .toMatch(/under the pointer, at 0\.2[45]\d/)
  const rows = [2, 7, 30].map((row, i) => runs[i]!.v[row]!.toFixed(2).replace('-', '−'))
  const speeds = await lab.values('speed')
  // The pointer is on a whole pixel, which may be just before a frame of the fastest.
  expect(speeds.slice(0, 2)).toEqual(rows.slice(0, 2).map((each) => `${each}\u202fm/s`))
  expect(Number.parseFloat(speeds[2]!.replace('−', '-'))).toBeCloseTo(runs[2]!.v[30]!, 0)
  expect(await lab.now()).toBe(1)
  expect(await box()).toEqual(before)
  await page.mouse.move(x, 5)
  await expect.poll(() => lab.values('position')).toContain('−1.72\u202fm')
  await lab.plot('speed').locator('li').first().hover()
  expect(await lab.plot('speed').locator('li').first().getAttribute('title')).toContain(
    '10 fps: 0 m/s',
  )
})

test('a click goes there, a drag takes the time along', async () => {
  const lab = await openPlots()
  const { page } = lab
  const from = await at(page, 'position', 0.3)
  await page.mouse.click(from.x, from.y)
  expect(await lab.now()).toBeCloseTo(0.3, 1)
  await page.mouse.down()
  const to = await at(page, 'position', 0.6)
  await page.mouse.move(to.x, to.y)
  expect(await lab.now()).toBeCloseTo(0.6, 1)
  await page.mouse.up()
  const away = await at(page, 'position', 0.1)
  await page.mouse.move(away.x, away.y)
  expect(await lab.now()).toBeCloseTo(0.6, 1)
  // Speed over position has no time axis: the nearest point's time counts.
  const start = await at(page, 'phase', 0.99, 0.99)
  await page.mouse.click(start.x, start.y)
  expect(await lab.now()).toBeLessThan(0.1)
  expect(lab.problems).toEqual([])
})

test('a finger goes to a time and does not scroll', async () => {
  const lab = await openPlots('', { width: 390, height: 800, hasTouch: true })
  const { x, y } = await at(lab.page, 'position', 0.5)
  await lab.page.touchscreen.tap(x, y)
  await expect.poll(lab.now).toBeCloseTo(0.5, 1)
})

test('by keyboard: the arrow keys go from frame to frame, and the values are told', async () => {
  const lab = await openPlots()
  const { page } = lab
  await lab.area('speed').focus()
  await page.keyboard.press('Home')
  await page.keyboard.press('Shift+ArrowRight')
  await page.keyboard.press('Shift+ArrowRight')
  expect(await lab.now()).toBe(20 / 120)
  const told = lab.plot('speed').locator('output')
  await expect
    .poll(() => told.textContent())
    .toBe(
      `Speed at 0.17\u202fs: 10 fps −4.27\u202fm/s, 30 fps −3.79\u202fm/s, 120 fps −3.79\u202fm/s, exact −3.79\u202fm/s.`,
    )
  expect(await lab.plot('position').locator('output').textContent()).toBe('')
})

test('a table is made when it is opened, follows changes, and scrolls inside itself', async () => {
  const lab = await openPlots('', { width: 320 })
  const { page } = lab
  expect(await page.locator('slide-lab-plots table').count()).toBe(0)
  await lab.plot('position').locator('summary').click()
  const table = lab.plot('position').getByRole('table')
  await table.waitFor()
  expect(await table.getByRole('columnheader').allInnerTexts()).toEqual([
    'time (s)',
    '10 fps, position (m)',
    '30 fps, position (m)',
    '120 fps, position (m)',
    'exact, position (m)',
  ])
  expect(await table.locator('tbody tr').count()).toBe(25)
  const last = () => table.locator('tbody tr').last().locator('td').allInnerTexts()
  expect(await last()).toEqual(
    [...runs.map(({ drawnS }) => drawnS.at(-1)!), truth(1).s].map((s) =>
      s.toFixed(3).replace('-', '−'),
    ),
  )
  await page.evaluate(() => {
    const lab = document.querySelector('slide-lab') as unknown as {
      change: (change: object) => void
    }
    lab.change({ kind: 'parameters', values: { speed: 0 } })
  })
  await expect.poll(last).toEqual(['0.000', '0.000', '0.000', '0.000'])
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320)
})

test('what can’t be seen is not drawn', async () => {
  const lab = await openPlots('', { height: 700 })
  const { page } = lab
  const before = await lab.pixelsOf('position', CHART)
  await page.evaluate(() => scrollTo(0, 0))
  await outOfSight(page.locator('slide-lab-plots .multiples'))
  await page.evaluate(() => {
    const lab = document.querySelector('slide-lab') as unknown as {
      change: (change: object) => void
    }
    lab.change({ kind: 'parameters', values: { angle: 30 } })
  })
  await page.waitForTimeout(150)
  expect(await lab.pixelsOf('position', CHART)).toBe(before)
  await page.locator('slide-lab-plots .multiples').evaluate((each) => each.scrollIntoView())
  await expect.poll(() => lab.pixelsOf('position', CHART)).not.toBe(before)
})

test('on a phone there is one plot at a time', async () => {
  const lab = await openPlots('', { width: 390 })
  const { page } = lab
  const visible = () =>
    page
      .locator('slide-lab-plot')
      .evaluateAll((all) =>
        all.filter((each) => each.checkVisibility()).map((each) => each.getAttribute('data-plot')),
      )
  expect(await visible()).toEqual(['position'])
  await page
    .getByRole('group', { name: 'Which plot' })
    .getByRole('button', { name: 'Error' })
    .click()
  expect(await visible()).toEqual(['error'])
  await lab.plot('error').locator('canvas.chart').waitFor()
  expect(await lab.values('error')).toEqual(['0.246\u202fm', '0.082\u202fm', '0.021\u202fm'])
})

test('the energy residual of a fall with drag is drawn, and says that it counts the heat of drag', async () => {
  const lab = await openPlots('scene=fall')
  await lab.plot('energy').locator('canvas.chart').waitFor()
  expect(await lab.plot('energy').locator('figcaption').innerText()).toContain('heat of drag')
  expect(lab.problems).toEqual([])
})

test('another theme draws other colours', async () => {
  const lab = await openPlots()
  const before = await lab.pixelsOf('speed', CHART)
  await lab.page.evaluate(() => (document.documentElement.dataset.theme = 'dark'))
  await expect.poll(() => lab.pixelsOf('speed', CHART)).not.toBe(before)
})

test.each(some(['light', 'dark'] as const, 1))(
  'axe finds nothing in the %s theme',
  async (colorScheme) => {
    const lab = await openPlots('', { colorScheme })
    await lab.plot('phase').locator('summary').click()
    expect(await violationsOn(lab.page, 'slide-lab-plots')).toEqual([])
    expect(lab.problems).toEqual([])
  },
)

test.each(some([320, 390, 768, 1440], 0, 2))(
  'nothing is wider than a page of %i px',
  async (width) => {
    const lab = await openPlots('runners=10;15;24;30;60;90;120;144', { width })
    expect(await lab.page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    const cut = await lab.page
      .locator('slide-lab-plots')
      .evaluate((plots) =>
        [...plots.querySelectorAll('.value, h3, figcaption p, button')]
          .filter(
            (each) =>
              each.checkVisibility() &&
              each.scrollWidth > each.clientWidth + 1 &&
              getComputedStyle(each).display !== 'inline',
          )
          .map((each) => each.textContent),
      )
    expect(cut).toEqual([])
  },
)
