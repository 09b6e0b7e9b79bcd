import type { Page, Route } from 'playwright-core'
import { expect, inject, test } from 'vitest'
import { some } from '../samples.ts'
import { openPage } from './page.ts'

/** The page with nothing but its lab alive: what that loads afterwards waits until it is let go. */
async function openEarly(width = 1280) {
  const { page, problems } = await openPage({ path: '404.html', width, reducedMotion: 'reduce' })
  const html = await (await page.request.get(inject('address'))).text()
  const waiting: Route[] = []
  let held = true
  await page.route(/\.js$/, (route) => {
    const isNamed = html.includes(route.request().url().replace(/.*\//, ''))
    if (held && !isNamed) waiting.push(route)
    else void route.continue()
  })
  await page.goto(inject('address'), { waitUntil: 'commit' })
  await page.locator('slide-stage canvas').waitFor()
  await page.evaluate(() => document.fonts.ready.then(() => undefined))
  return {
    page,
    problems,
    letGo: async () => {
      held = false
      for (const route of waiting) void route.continue()
      await page.locator('slide-lab-measures:defined').waitFor({ state: 'attached' })
    },
  }
}

const places = (page: Page) =>
  page.evaluate(() =>
    ['.tools .toggle', '.presets', 'slide-stage', '.transport', 'slide-frame-strip', '.clock'].map(
      (selector) => document.querySelector(selector)!.getBoundingClientRect().toJSON() as object,
    ),
  )

test('the first paint waits for the page and one file of styles', async () => {
  const { page } = await openPage({ path: '404.html' })
  const asked: string[] = []
  await page.route('**/*', (route) => {
    const request = route.request()
    const isStyles = request.resourceType() === 'stylesheet'
    if (isStyles) asked.push(request.url())
    if (isStyles || request.isNavigationRequest()) void route.continue()
    // All others are never answered: what waits for them waits for ever.
  })
  await page.goto(inject('address'), { waitUntil: 'commit' })
  await page.waitForFunction(() => performance.getEntriesByName('first-contentful-paint').length)
  expect(asked).toHaveLength(1)
})

test('what makes the page alive runs after its first frame', async () => {
  const { page } = await openPage({ path: '404.html' })
  await page.addInitScript(() => {
    const frame = window.requestAnimationFrame.bind(window)
    const held: FrameRequestCallback[] = []
    window.requestAnimationFrame = (then) => held.push(then)
    Object.assign(window, {
      letFramesGo: () => {
        window.requestAnimationFrame = frame
        for (const then of held) frame(then)
      },
    })
  })
  await page.goto(inject('address'))
  const isAlive = () => page.evaluate(() => customElements.get('slide-lab') !== undefined)
  // All that it needs is there by now, and without a frame it would never come.
  await page.waitForTimeout(500)
  expect(await isAlive()).toBe(false)
  await page.evaluate(() => (window as unknown as { letFramesGo: () => void }).letFramesGo())
  await expect.poll(isAlive).toBe(true)
  // And nothing that is imported at once is more than a few lines.
  const html = await (await page.request.get(inject('address'))).text()
  const [, script] = /<script type="module"[^>]* src="([^"]+)"/.exec(html)!
  const code = await (await page.request.get(new URL(script!, inject('address')).href)).text()
  const imported = [...code.matchAll(/\bimport\s*(?:[\w{},* ]+from)?\s*["'`]([^"'`]+)/g)]
  for (const [, name] of imported) expect(name).toMatch(/\/load-/)
})

test('the picture, the buttons, the time and undo are alive before anything else is loaded', async () => {
  const { page, problems, letGo } = await openEarly()
  const spread = page.locator('.spread output')
  expect(await spread.innerText()).toMatch(/^0\.23\sm$/)
  await page.getByRole('button', { name: 'Located' }).click()
  expect(await spread.innerText()).toBe('0 (to rounding)')
  await page.getByRole('slider', { name: 'Tilt the track' }).press('ArrowUp')
  await page.getByRole('slider', { name: 'Time', exact: true }).press('Home')
  expect(await page.locator('.clock span').innerText()).toBe('0.00')
  await page.getByRole('button', { name: 'Undo' }).click()
  await page.getByRole('button', { name: 'Undo' }).click()
  expect(await spread.innerText()).toMatch(/^0\.23\sm$/)
  await page.getByRole('button', { name: 'The paper' }).click()
  expect(await page.locator('slide-runner-row').count()).toBe(0)
  await letGo()
  // What was changed early is what is shown and written later.
  const stopping = page.getByRole('combobox', { name: 'Stopping, 10 fps' })
  expect(await stopping.inputValue()).toBe('naive')
  await expect.poll(() => page.evaluate(() => location.hash)).toContain('naive')
  expect(problems).toEqual([])
})

test.each(some([1440, 768, 390], 0, 2))(
  '%i px wide, what comes later moves nothing',
  async (width) => {
    const { page, letGo } = await openEarly(width)
    const before = await places(page)
    await letGo()
    await page.locator('slide-lab-plots').waitFor()
    expect(await places(page)).toEqual(before)
  },
)

test('the text is laid out while nothing moves, and all of it where a link leads into it', async () => {
  const { page } = await openPage({ path: '404.html', reducedMotion: 'reduce' })
  await page.addInitScript(() => {
    // A run that plays: each frame has something to draw.
    const draw = () => {
      for (const start = performance.now(); performance.now() - start < 12;);
      if (!('halted' in window)) requestAnimationFrame(draw)
    }
    requestAnimationFrame(draw)
  })
  const laidOut = () => page.evaluate(() => document.querySelectorAll('.text > .laid-out').length)
  const sections = await page
    .goto(inject('address'))
    .then(() => page.locator('.text > section').count())
  await page.locator('slide-lab-measures:defined').waitFor({ state: 'attached' })
  await page.waitForTimeout(500)
  expect(await laidOut()).toBe(0)
  await page.evaluate(() => (location.hash = 'energy'))
  await expect.poll(laidOut).toBe(sections)

  await page.goto('about:blank')
  await page.goto(inject('address'))
  await page.locator('slide-lab-measures:defined').waitFor({ state: 'attached' })
  await page.evaluate(() => Object.assign(window, { halted: true }))
  await expect.poll(laidOut).toBe(sections)
})

test('a press on Share before it can answer opens it when it can', async () => {
  const { page, problems, letGo } = await openEarly()
  await page.getByRole('button', { name: 'Share' }).press('Enter')
  await letGo()
  await page.getByRole('button', { name: 'Copy link' }).waitFor()
  expect(await page.evaluate(() => document.activeElement!.textContent.trim())).toBe('Share')
  expect(problems).toEqual([])
})

test('a press on the presets before there are any is not lost', async () => {
  const { page, problems, letGo } = await openEarly()
  const menu = page.getByRole('combobox', { name: 'Presets' })
  expect(await menu.locator('option').count()).toBe(1)
  await page.evaluate(() => {
    const shown = HTMLSelectElement.prototype.showPicker
    HTMLSelectElement.prototype.showPicker = function () {
      this.dataset.shown = String(this.options.length)
      shown.call(this)
    }
  })
  await menu.click()
  await letGo()
  await expect.poll(() => menu.getAttribute('data-shown')).not.toBeNull()
  expect(Number(await menu.getAttribute('data-shown'))).toBeGreaterThan(20)
  expect(await menu.evaluate((each) => each === document.activeElement)).toBe(true)
  expect(problems).toEqual([])
})

test('an address is read before anything is shown', async () => {
  const { page } = await openPage({ path: '404.html' })
  const waiting: Route[] = []
  let held = true
  await page.route(/\/assets\/address[^/]*\.js$/, (route) => {
    if (held) waiting.push(route)
    else void route.continue()
  })
  await page.goto(new URL('#scene=half-pipe', inject('address')).href, { waitUntil: 'commit' })
  await expect.poll(() => waiting.length).toBeGreaterThan(0)
  expect(await page.locator('slide-stage').count()).toBe(0)
  held = false
  for (const route of waiting) void route.continue()
  await page.locator('slide-stage canvas').waitFor()
  expect(await page.getByRole('radio', { name: 'Half-pipe' }).isChecked()).toBe(true)
})

test('a link that sets a figure, pressed before there are figures, sets it', async () => {
  const { page, problems, letGo } = await openEarly()
  const link = page.locator('a[data-set]').first()
  const name = (await link.getAttribute('data-set'))!.split('?')[0]!
  await link.click()
  expect(await page.evaluate(() => location.hash)).toBe('')
  await letGo()
  await page.locator(`#figure-${name} slide-figure[live]`).waitFor()
  expect(problems).toEqual([])
})
