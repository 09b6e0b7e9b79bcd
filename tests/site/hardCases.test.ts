import { describe, expect, test } from 'vitest'
import { hardCases } from '../../src/measure/index.ts'
import { violationsOn } from './axe.ts'
import { openPage } from './page.ts'

describe('the hard cases on the page', () => {
  test.each([
    [1440, 'light'],
    [320, 'dark'],
  ] as const)(
    'axe finds nothing at %i px, %s, and nothing is too wide',
    async (width, colorScheme) => {
      const { page, problems } = await openPage({ width, colorScheme })
      expect(await violationsOn(page, '#hard-cases')).toEqual([])
      const excess = await page
        .locator('.hard-cases :is(.table, th, td)')
        .evaluateAll((boxes) => Math.max(...boxes.map((box) => box.scrollWidth - box.clientWidth)))
      expect(excess).toBe(0)
      expect(problems).toEqual([])
    },
  )

  test('are there without JavaScript, with an entry in the contents', async () => {
    const { page } = await openPage({ javaScriptEnabled: false })
    const section = page.locator('#hard-cases')
    expect(await section.locator('tbody').count()).toBe(hardCases.length)
    expect(await page.locator('.contents a[href="#hard-cases"]').innerText()).toBe('Hard cases')
    expect(await section.innerText()).toContain('leaves the pipe: as documented')
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
