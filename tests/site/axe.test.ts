import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openLab } from './labPage.ts'

/** Every runner that there is room for, of every clock and timestep, one of them hidden. */
const RUNNERS = [
  ...['10', '30/fixed(step:1/60)/clamped', 'jitter(fps:30,amount:0.5,seed:1)/capped(cap:1/30)'],
  ...['hitch(fps:60,every:0.5,length:0.2)/substeps(step:1/60)', 'missed-vsync(fps:60,seed:1)/rk4'],
  ...['60/per-frame(step:1/60)/naive', '120/hidden', 'recorded(durations:0.02+0.03)'],
].join(';')

async function openEverything(page: Page): Promise<void> {
  await page.locator('slide-lab-plots').scrollIntoViewIfNeeded()
  await page.locator('slide-lab-plots canvas.chart').first().waitFor()
  await page.getByRole('checkbox', { name: 'Show forces' }).check()
  await page
    .locator('slide-record-frames')
    .evaluate((recorder) => ((recorder as unknown as { length: number }).length = 0.3))
  await page.getByRole('button', { name: 'Record my frames' }).click()
  await page.getByRole('button', { name: 'Record again' }).waitFor()
  for (const summary of await page.locator('slide-lab summary').all())
    if (await summary.isVisible()) await summary.click()
  await page.locator('slide-lab-plots table').first().waitFor()
}

test.each(
  some(
    [
      ['light', 1280],
      ['light', 390],
      ['dark', 1280],
      ['dark', 390],
    ] as const,
    ...[0, 3],
  ),
)('axe finds nothing in the %s theme at %d px with everything open', async (colorScheme, width) => {
  const { page, problems } = await openLab(`runners=${RUNNERS}`, { width, colorScheme })
  await openEverything(page)
  await page.getByRole('button', { name: 'Share' }).click()
  expect(await violationsOn(page)).toEqual([])
  await page.getByRole('combobox', { name: 'Presets' }).selectOption({ index: 1 })
  await page.getByRole('textbox', { name: 'Angle' }).fill('steep')
  await page.keyboard.press('Enter')
  await page.getByRole('alert').waitFor()
  expect(await page.locator('.preset-note').innerText()).not.toBe('')
  expect(await violationsOn(page, '.preset-note', '.parameters', '.tools')).toEqual([])
  expect(problems).toEqual([])
})
