import type { Locator, Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import { some } from '../samples.ts'
import { middle, openLab } from './labPage.ts'
import type { Lab } from './labPage.ts'

const phone = { width: 390, height: 844, hasTouch: true }
/** Smaller than this no target may be [px]. */
const SMALLEST = 24

/** A finger on a thing, without a mouse anywhere. */
async function tap(page: Page, what: Locator): Promise<void> {
  await what.scrollIntoViewIfNeeded()
  const { x, y, width, height } = (await what.boundingBox())!
  await page.touchscreen.tap(x + width / 2, y + height / 2)
}

/** A finger put down on a handle and moved, in small parts. */
async function drag(page: Page, selector: string, dx: number, dy: number): Promise<void> {
  const { x, y } = await middle(page, selector)
  const session = await page.context().newCDPSession(page)
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: object[]) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points as never })
  await touch('touchStart', [{ x, y }])
  for (let i = 1; i <= 8; i++)
    await touch('touchMove', [{ x: x + (dx * i) / 8, y: y + (dy * i) / 8 }])
  await touch('touchEnd', [])
}

/** Opens all that can be opened. */
async function openAll({ page }: Lab): Promise<void> {
  await page.locator('slide-lab-plots').scrollIntoViewIfNeeded()
  await page.locator('slide-lab-plots canvas.chart').first().waitFor()
  await page.getByRole('combobox', { name: 'Presets' }).selectOption({ index: 3 })
  await tap(page, page.getByRole('checkbox', { name: 'Show forces' }))
  for (const summary of await page.locator('slide-lab summary').all())
    if (await summary.isVisible()) await tap(page, summary)
}

/** The targets that are too small, by the rule of WCAG 2.5.8: neither large enough nor far enough from the others. */
const tooSmall = (page: Page): Promise<string[]> =>
  page.evaluate((smallest) => {
    const all = 'button, input, select, summary, textarea, a[href], label, [tabindex="0"]'
    const targets = [...document.querySelectorAll<HTMLElement>(all)]
      .filter((each) => each.checkVisibility({ visibilityProperty: true }))
      // A link in running text is as high as its line.
      .filter((each) => !each.closest('p, .text :is(li, td), .visually-hidden'))
      .filter((each) => {
        // A label with its control in it is one target, and what is invisible is hit by its label.
        const label = each.closest('label')
        const { width } = each.getBoundingClientRect()
        return each.localName === 'label'
          ? each.querySelector('[type="radio"], [type="checkbox"]')
          : width > 1 && !label?.querySelector('[type="radio"], [type="checkbox"]')
      })
    return targets
      .filter((each) => {
        const { width, height } = each.getBoundingClientRect()
        return Math.min(width, height) < smallest - 0.01
      })
      .map((each) => {
        const { width, height } = each.getBoundingClientRect()
        return `${each.outerHTML.slice(0, 120)}: ${width} × ${height}`
      })
  }, SMALLEST)

describe('with a finger', () => {
  test.each([
    ['place', 'position', 30, -8],
    ['push', 'speed', 30, -8],
    ['tilt', 'angle', -10, -60],
  ])('the handle to %s is dragged and the page keeps still', async (id, parameter, dx, dy) => {
    const { page, state, handle, problems } = await openLab('', phone)
    await page.locator('slide-stage').evaluate((stage) => stage.scrollIntoView({ block: 'center' }))
    const { width, height } = (await page.locator(`[data-handle="${id}"]`).boundingBox())!
    expect(Math.min(width, height)).toBeGreaterThanOrEqual(44)
    const scrolled = await page.evaluate(() => scrollY)
    const before = (await state()).parameters[parameter]!
    await drag(page, `[data-handle="${id}"]`, dx, dy)
    const after = (await state()).parameters[parameter]!
    expect(after).not.toBe(before)
    expect(await page.evaluate(() => scrollY)).toBe(scrolled)
    const purpose = { place: 'Place', push: 'Push', tilt: 'Tilt' }[id]!
    expect(await handle(purpose).getAttribute('aria-valuenow')).toBe(String(after))
    // Elsewhere a finger scrolls as on any page.
    await drag(page, '.modes .about', 0, -100)
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(scrolled)
    expect(problems).toEqual([])
  })

  test('everything in the lab can be used', async () => {
    const { page, state, now, runner, problems } = await openLab('', phone)
    const button = (name: string | RegExp) => page.getByRole('button', { name }).first()

    await tap(page, page.getByText('Spring', { exact: true }))
    expect((await state()).scene).toBe('spring')
    await tap(page, button('Undo'))
    expect((await state()).scene).toBe('ramp')
    await tap(page, button('Redo'))
    expect((await state()).scene).toBe('spring')
    await tap(page, page.getByText('Ramp', { exact: true }))
    await tap(page, button('The paper'))
    expect((await state()).runners[0]!.stopping).toBe('naive')
    await tap(page, button('Clamped'))
    expect((await state()).runners[0]!.stopping).toBe('clamped')

    await tap(page, button('Share'))
    expect(await button('Copy link').isVisible()).toBe(true)
    await tap(page, page.locator('.lead'))
    expect(await button('Copy link').isVisible()).toBe(false)

    // A menu opens under the finger; what is chosen in it the system hands over.
    await page.getByRole('combobox', { name: 'Presets' }).selectOption({ index: 2 })
    await tap(page, button('Close the note'))
    expect(await page.locator('.preset-note').innerText()).toBe('')

    await tap(page, button('To the start'))
    expect(await now()).toBe(0)
    await tap(page, button('One frame forward'))
    const stepped = await now()
    expect(stepped).toBeGreaterThan(0)
    await tap(page, button('Play'))
    await expect.poll(now).toBeGreaterThan(stepped)
    if (await button('Pause').isVisible()) await tap(page, button('Pause'))
    await tap(page, page.getByRole('slider', { name: 'Time', exact: true }))
    expect(await now()).toBeCloseTo((await state()).duration / 2, 1)

    await tap(page, page.getByRole('checkbox', { name: 'Show forces' }))
    expect(await page.locator('.forces table').isVisible()).toBe(true)
    await tap(page, page.getByRole('slider', { name: 'Angle, slider' }))
    expect((await state()).parameters.angle).toBe(30)
    await tap(page, button('Reset Angle'))
    expect((await state()).parameters.angle).toBe(15)
    await tap(page, page.getByRole('textbox', { name: 'Angle' }))
    await page.keyboard.type('12')
    await page.keyboard.press('Enter')
    expect((await state()).parameters.angle).toBe(12)

    await tap(page, runner(1).getByRole('button', { name: /^Hide/ }))
    expect((await state()).runners[1]!.hidden).toBe(true)
    await tap(page, runner(1).getByRole('button', { name: /^Duplicate/ }))
    expect((await state()).runners.length).toBe(4)
    await tap(page, runner(1).getByRole('button', { name: /^Remove/ }))
    expect((await state()).runners.length).toBe(3)
    await tap(page, button('Add a runner'))
    expect((await state()).runners.length).toBe(4)
    await tap(page, runner(0).locator('slide-runner-mark'))
    expect(await runner(0).getAttribute('selected')).not.toBeNull()

    await page.locator('slide-lab-plots canvas.chart').first().waitFor()
    await tap(page, page.getByText('As a table').first())
    await page.locator('slide-lab-plots table').first().waitFor()
    await tap(page, page.getByText('Inside this step'))
    await tap(page, button('Previous frame'))
    expect(problems).toEqual([])
  })

  test.each(
    some(
      [
        [390, ''],
        [320, ''],
        [768, ''],
        [
          390,
          'runners=recorded(durations:0.02);hitch(fps:60,every:0.5,length:0.2)/fixed(step:1/60)',
        ],
      ],
      ...[1, 3],
    ),
  )('no target at %d px is smaller than 24 px: %s', async (width, address) => {
    const lab = await openLab(address, { ...phone, width })
    expect(await tooSmall(lab.page)).toEqual([])
    await openAll(lab)
    expect(await tooSmall(lab.page)).toEqual([])
    expect(await lab.page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
  })
})
