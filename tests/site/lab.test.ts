import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { framesAsked } from './frames.ts'
import { openLab, openLabOverText } from './labPage.ts'

test('the lab opens on a picture that is already wrong, without a problem', async () => {
  const { page, problems, spread, runner, time } = await openLab()
  expect(await page.title()).toBe('Any Frame Rate')
  expect(await spread()).toBe('0.23\u202fm')
  expect(
    await page.locator('slide-lab').getByRole('button', { pressed: true }).allInnerTexts(),
  ).toEqual(['Clamped'])
  expect(await time().getAttribute('aria-valuetext')).toBe('1.00 of 1.00 seconds')
  const ends = await page.locator('slide-runner-row .end output').allInnerTexts()
  expect(ends).toEqual(['−0.246\u202fm', '−0.082\u202fm', '−0.021\u202fm'])
  expect(await runner(0).locator('.now output').innerText()).toBe(ends[0])
  expect(await page.locator('slide-stage').getByRole('img').getAttribute('aria-label')).toContain(
    '10 fps: stopped at 1.47',
  )
  expect(await page.evaluate(() => location.hash)).toBe('')
  expect(problems).toEqual([])
})

test('nothing moves by itself, and nothing asks for animation frames while nothing moves', async () => {
  const { page } = await openLab()
  await expect.poll(() => framesAsked(page)).toBe(0)
})

test('several labs stand on one page, each with its own state', async () => {
  const { page, problems } = await openLab()
  const scenes = await page.evaluate(async () => {
    type Lab = HTMLElement & { state: { scene: string }; change: (change: object) => string }
    const [first] = document.querySelectorAll<Lab>('slide-lab')
    const second = document.createElement('slide-lab') as Lab
    document.querySelector('main')!.append(second)
    second.change({ kind: 'scene', scene: 'fall' })
    await new Promise((resolve) => setTimeout(resolve, 500))
    return [first!.state.scene, second.state.scene, location.hash]
  })
  expect(scenes).toEqual(['ramp', 'fall', ''])
  const ids = await page.evaluate(() => [...document.querySelectorAll('[id]')].map(({ id }) => id))
  expect(new Set(ids).size).toBe(ids.length)
  expect(problems).toEqual([])
})

test('the theme goes from the system’s to light to dark, in page and picture', async () => {
  const { page, pixels } = await openLab('', { colorScheme: 'dark' })
  const paper = () =>
    page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor)
  const byTheSystem = [await paper(), await pixels()]
  await page.getByRole('button', { name: 'Theme: system' }).click()
  await expect.poll(async () => [await paper(), await pixels()]).not.toContain(byTheSystem[0])
  expect(await pixels()).not.toEqual(byTheSystem[1])
  await page.getByRole('button', { name: 'Theme: light' }).click()
  await expect.poll(async () => [await paper(), await pixels()]).toEqual(byTheSystem)
  await page.getByRole('button', { name: 'Theme: dark' }).click()
  expect(await page.getByRole('button', { name: 'Theme: system' }).count()).toBe(1)
})

test.each(
  some(
    [
      [1280, 'light'],
      [390, 'light'],
      [1280, 'dark'],
      [390, 'dark'],
    ] as const,
    3,
  ),
)('at %d px axe finds nothing in the %s theme', async (width, colorScheme) => {
  const { page, goTo } = await openLab('', { width, colorScheme })
  await axeFindsNothing(page)
  // With an open problem, every kind of option, a hidden runner, and a way of its own.
  await goTo(
    '#runners=10/fixed(step:1/60);hitch(fps:30,every:1,length:0.2);recorded(durations:0.02)/hidden',
  )
  await page.getByRole('textbox', { name: 'Angle' }).fill('95')
  await page.getByRole('textbox', { name: 'Angle' }).press('Enter')
  expect(await page.getByRole('alert').count()).toBe(1)
  await axeFindsNothing(page)
  await goTo('#angle=95')
  await axeFindsNothing(page)
})

async function axeFindsNothing(page: Page): Promise<void> {
  // The first paragraph of it is written once the picture has come to rest.
  await page.waitForTimeout(100)
  expect(await violationsOn(page)).toEqual([])
}

test.each(some([320, 390, 640, 768, 1024, 1440], 0, 2, 4))(
  '%d px wide, nothing is cut off',
  async (width) => {
    const { page, goTo } = await openLab('', { width, hasTouch: width < 800 })
    for (const address of ['#', '#scene=run-out', '#scene=spring', '#angle=95&b=1', EIGHT]) {
      await goTo(address)
      await expect
        .poll(() => page.locator('slide-runner-row').count())
        .toBe(address === EIGHT ? 8 : 3)
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
      expect(await overflowing(page), address).toEqual([])
    }
  },
)

const EIGHT =
  '#runners=10/fixed(step:1/60)/semi-implicit-euler;jitter(fps:30,amount:0.5,seed:1)/rk4;' +
  'hitch(fps:60,every:0.7,length:0.3)/substeps(step:1/100)/clamped;missed-vsync(fps:60,seed:2)/capped(cap:0.02);' +
  'recorded(durations:0.016+0.033)/explicit-euler;5/per-frame(step:0.1);24/yoshida4;144/implicit-midpoint/naive'

/** What sticks out of the sheet, or out of a box that cuts it off. */
function overflowing(page: Page): Promise<string[]> {
  return page.evaluate(() => {
    const found: string[] = []
    const sheet = document.querySelector('.sheet')!.getBoundingClientRect()
    for (const element of document.querySelectorAll<HTMLElement>('.sheet *')) {
      if (element.closest('.visually-hidden, slide-stage, svg')) continue
      const { left, right, width } = element.getBoundingClientRect()
      const sticksOut = width > 0 && (left < sheet.left - 0.5 || right > sheet.right + 0.5)
      const isCut =
        element.matches('button, output, label, h2, dt, .clock') &&
        element.scrollWidth > element.clientWidth + 1 &&
        getComputedStyle(element).display !== 'inline'
      if (sticksOut || isCut)
        found.push(`${element.localName}.${element.className} ${element.innerText}`)
    }
    return found
  })
}

test('one block alone is apart from nothing: the spread is a dash, not a promise', async () => {
  const { spread, problems } = await openLab('runners=10/semi-implicit-euler/clamped')
  expect(await spread()).toBe('–')
  expect(problems).toEqual([])
})

test('the large number is of frame rates only where the blocks differ in nothing else', async () => {
  const { page, runner } = await openLab()
  const label = page.locator('.spread span').first()
  expect(await label.innerText()).toBe('frame-rate spread')
  await runner(0).getByRole('combobox', { name: 'Integrator' }).selectOption('rk4')
  await expect.poll(() => label.innerText()).toBe('apart at the end')
  // One that is not seen is not compared.
  await runner(0).getByRole('button', { name: /^Hide/ }).click()
  await expect.poll(() => label.innerText()).toBe('frame-rate spread')
})

test.each(some([320, 390, 768, 1440], 0, 2))(
  'at %i px none of the buttons moves the picture',
  async (width) => {
    const { page } = await openLab('', { width })
    const top = () =>
      page
        .locator('slide-stage')
        .evaluate((stage) => Math.round(stage.getBoundingClientRect().top + scrollY))
    const before = await top()
    const buttons = page.locator('.modes button')
    expect(await buttons.count()).toBe(6)
    for (const button of await buttons.all()) {
      await button.click()
      await expect.poll(() => button.getAttribute('aria-pressed')).toBe('true')
      expect(await top()).toBe(before)
    }
  },
)

test.each([
  [390, 844],
  [360, 740],
])('on a phone of %i by %i px the first screen has the picture', async (width, height) => {
  const { page } = await openLabOverText('', { width, height })
  const { top, bottom } = await page
    .locator('slide-stage')
    .evaluate((stage) => stage.getBoundingClientRect())
  // The blocks stand above the middle: the lower third is ground.
  expect(top + (2 / 3) * (bottom - top)).toBeLessThan(height)
})
