import type { Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import { hardCases } from '../../src/measure/index.ts'
import { violationsOn } from './axe.ts'
import { some } from '../samples.ts'
import { openPage } from './page.ts'

describe('the hard cases on the page', () => {
  test.each(
    some(
      [
        [1440, 'light'],
        [320, 'dark'],
      ] as const,
      1,
    ),
  )('axe finds nothing at %i px, %s, and nothing is too wide', async (width, colorScheme) => {
    const { page, problems } = await openPage({ width, colorScheme })
    await unfold(page)
    expect(await violationsOn(page, '#hard-cases')).toEqual([])
    const excess = await page
      .locator('.hard-cases :is(.table, th, td)')
      .evaluateAll((boxes) => Math.max(...boxes.map((box) => box.scrollWidth - box.clientWidth)))
    expect(excess).toBe(0)
    expect(problems).toEqual([])
  })

  test.each([1440, 390])(
    'are folded to a line a group at %i px, and open by their line and on paper',
    async (width) => {
      const { page } = await openPage({ width })
      const folds = page.locator('.hard-cases details')
      const heights = await folds.evaluateAll((all) => all.map(({ clientHeight }) => clientHeight))
      expect(heights.length).toBeGreaterThan(5)
      // A heading of one line, or two on a phone, with its room.
      expect(Math.max(...heights)).toBeLessThan(100)
      const tables = page.locator('.hard-cases table:visible')
      expect(await tables.count()).toBe(0)
      await folds.first().locator('summary .counts').click()
      expect(await tables.count()).toBe(1)
      await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
      expect(await tables.count()).toBe(heights.length)
      await page.evaluate(() => dispatchEvent(new Event('afterprint')))
      expect(await tables.count()).toBe(1)
    },
  )

  test('are there without JavaScript, with an entry in the contents', async () => {
    const { page } = await openPage({ javaScriptEnabled: false })
    const section = page.locator('#hard-cases')
    expect(await section.locator('tbody').count()).toBe(hardCases.length)
    expect(await page.locator('.contents a[href="#hard-cases"]').innerText()).toBe('Hard cases')
    expect(await section.textContent()).toContain('leaves the pipe: as documented')
  })

  test('each has an address of its own', async () => {
    const { page } = await openPage({ path: '#hard-case-like-glue' })
    const { y } = (await page.locator('#hard-case-like-glue').boundingBox())!
    expect(y).toBeGreaterThanOrEqual(0)
    expect(y).toBeLessThan(200)
    // A place in the page is no experiment for the lab.
    expect(await page.getByRole('alert').count()).toBe(0)
  })

  test('open in the lab, one after the other', async () => {
    const { page, problems } = await openPage({ reducedMotion: 'reduce' })
    await unfold(page)
    for (const [id, runners] of [
      ['pipe-from-89-degrees', 7],
      ['five-fps', 3],
    ] as const) {
      await page.locator(`#hard-case-${id} a[data-lab]`).click()
      await expect.poll(() => page.locator('slide-runner-row').count()).toBe(runners)
    }
    await page.locator('#hard-case-zero-mass a[data-lab]').click()
    const alert = page.getByRole('alert')
    await alert.waitFor()
    expect(await alert.innerText()).toContain('mass')
    expect(problems).toEqual([])
  })
})

/** Opens all groups. */
async function unfold(page: Page): Promise<void> {
  await page
    .locator('.hard-cases details')
    .evaluateAll((folds) => folds.forEach((fold) => ((fold as HTMLDetailsElement).open = true)))
}
