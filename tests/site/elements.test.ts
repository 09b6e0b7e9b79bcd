import { expect, test } from 'vitest'
import type { SlideFigureElement, SlideLabElement } from '../../src/elements.ts'
import { simulate } from '../../src/physics/index.ts'
import { violationsOn } from './axe.ts'
import { builtElements } from './hosts.ts'
import { lab, openHost, spread } from './wildPage.ts'

/* The elements in other people's pages, from the one file that such a page loads. */

const { module, files } = builtElements()

test('it is one file', () => {
  expect(files).toEqual(['slide-lab.js'])
  // All that it asks for is whether there is a lab.
  expect(module.match(/\bimport\s*\(.*?\)/g)!.join()).toMatch(/^import\(`\$\{\w+\}lab\.js`\)$/)
  expect(module).not.toMatch(/^import\b/m)
})

test.each([{}, { colorScheme: 'dark' as const }, { width: 390 }])(
  'a wild page and the elements leave each other alone, with %o',
  async (options) => {
    const { page, problems } = await openHost(
      '<slide-lab compact><p>No scripts</p><p slot="caption">Fig. 1</p></slide-lab>' +
        '<slide-figure name="area-under-v"></slide-figure><p id="theirs">Text</p>',
      options,
    )
    expect(await spread(page)).toBe('0.23\u202fm')
    await page.locator('slide-figure [live]').waitFor()
    const style = (selector: string, name: string) =>
      page
        .locator(selector)
        .first()
        .evaluate((element, name) => getComputedStyle(element).getPropertyValue(name), name)
    expect(await style('body', 'background-color')).toBe('rgba(0, 0, 0, 0)')
    expect(await style('main > button', 'padding-left')).toBe('30px')
    expect(await style('#theirs', 'margin-top')).toBe('50px')
    expect(await style('[slot=caption]', 'color')).toBe('rgb(0, 128, 0)')
    expect(await style('slide-lab .modes button', 'background-color')).not.toBe('rgb(255, 0, 0)')
    expect(await style('slide-lab .modes button', 'padding-left')).not.toBe('30px')
    expect(await style('slide-lab .sheet', 'letter-spacing')).toBe('normal')
    expect(await style('slide-lab .sheet', 'text-align')).toMatch(/^(start|left)$/)
    expect(await page.getByText('No scripts').isVisible()).toBe(false)
    expect(await page.getByText('Fig. 1').isVisible()).toBe(true)
    expect(await page.evaluate(() => document.adoptedStyleSheets.length)).toBe(0)
    const { width } = page.viewportSize()!
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    expect(problems).toEqual([])
  },
)

test('attributes and properties say what is run: bit for bit what simulate gives', async () => {
  const { page, problems } = await openHost(
    '<slide-lab scene="run-out" fps="12 75" integrator="rk4" stopping="located" duration="3"></slide-lab>',
  )
  await lab(page).locator('slide-runner-row').first().waitFor()
  const shown = () =>
    lab(page).evaluate((element) => {
      const { experiments, trajectories } = element as unknown as SlideLabElement
      return { experiments, ends: trajectories.map(({ s }) => s.at(-1)!) }
    })
  const first = await shown()
  expect(first.experiments).toMatchObject([
    { scene: 'run-out', integrator: 'rk4', duration: 3, frames: { fps: 12 } },
    { scene: 'run-out', integrator: 'rk4', duration: 3, frames: { fps: 75 } },
  ])
  expect(first.ends).toEqual(first.experiments.map((each) => simulate(each).s.at(-1)))
  const experiment = { scene: 'spring', parameters: { stiffness: 90 } } as const
  await lab(page).evaluate(async (element, experiment) => {
    const lab = element as unknown as SlideLabElement
    for (const name of ['scene', 'fps', 'integrator', 'stopping']) lab.removeAttribute(name)
    lab.experiment = experiment
    lab.duration = 2
    await lab.updateComplete
  }, experiment)
  const second = await shown()
  expect(second.ends).toEqual([simulate({ ...experiment, duration: 2 }).s.at(-1)])
  expect(problems).toEqual([])
})

test('a page may choose the theme and the colours', async () => {
  const { page } = await openHost(
    '<style>#mine { --accent: rgb(192, 0, 170) }</style>' +
      '<slide-lab compact id="mine"></slide-lab><slide-lab compact theme="dark"></slide-lab>',
  )
  const colours = await lab(page).evaluateAll((labs) =>
    labs.map((lab) =>
      ['.sheet', '.play'].map(
        (name) => getComputedStyle(lab.shadowRoot!.querySelector(name)!).backgroundColor,
      ),
    ),
  )
  // From theme.css: the light sheet with the page's accent, and the dark sheet with its own.
  expect(colours).toEqual([
    ['rgb(255, 255, 255)', 'rgb(192, 0, 170)'],
    ['rgb(27, 32, 38)', 'rgb(122, 180, 255)'],
  ])
})

test('events tell what the reader does, what moves, and what can’t be run', async () => {
  const { page } = await openHost('<slide-lab compact></slide-lab>')
  await lab(page).evaluate((element) => {
    const log: string[] = []
    Object.assign(window, { log })
    for (const type of ['change', 'timeupdate', 'error'])
      element.addEventListener(type, (event) => {
        const { experiments, time, message } = (event as CustomEvent).detail
        log.push(`${type} ${experiments?.[0].integrator ?? time ?? message}`)
      })
  })
  const log = () => page.evaluate(() => (window as unknown as { log: string[] }).log.splice(0))
  await page.getByRole('button', { name: 'Located' }).click()
  await expect.poll(() => spread(page)).toContain('0')
  expect(await log()).toContain('change velocity-verlet')
  await page.getByRole('button', { name: 'start' }).first().click()
  expect(await log()).toContain('timeupdate 0')
  await lab(page).evaluate((element) => element.setAttribute('fps', '-1'))
  await expect.poll(() => page.getByRole('alert').innerText()).toContain('fps: -1 is not in')
  expect(await log()).toEqual([expect.stringMatching(/^error fps: -1 is not in/)])
  await lab(page).evaluate((element) => element.setAttribute('fps', '15'))
  await expect.poll(() => page.getByRole('alert').count()).toBe(0)
  expect((await log()).some((line) => line.startsWith('change '))).toBe(true)
})

test('a theme that there is not is told of, and changes nothing that a reader has done', async () => {
  const { page } = await openHost(
    '<slide-lab compact fps="20 40"></slide-lab><slide-figure name="area-under-v"></slide-figure>',
  )
  await page.getByRole('button', { name: 'Located' }).click()
  await expect.poll(() => spread(page)).toMatch(/^0/)
  await page.locator('slide-figure [live]').waitFor()
  for (const element of [lab(page), page.locator('slide-figure')]) {
    await element.evaluate((each) => each.setAttribute('theme', 'sepia'))
    await expect
      .poll(() => element.getByRole('alert').innerText())
      .toContain('theme: “sepia” is neither light nor dark')
    await element.evaluate((each) => each.setAttribute('theme', 'dark'))
    await expect.poll(() => element.getByRole('alert').count()).toBe(0)
  }
  expect(await spread(page)).toMatch(/^0/)
})

test('a figure tells its changes, and a name that there is not', async () => {
  const { page } = await openHost(
    '<slide-figure name="area-under-v" style="max-width: 400px"></slide-figure><slide-figure name="no"></slide-figure>',
  )
  const figure = page.locator('slide-figure[name=area-under-v]')
  await figure.locator('[live]').waitFor()
  expect((await figure.boundingBox())!.width).toBe(400)
  await expect.poll(() => page.getByRole('alert').innerText()).toContain('There is no figure “no”')
  await figure.evaluate((element) =>
    element.addEventListener('change', ({ detail }: CustomEventInit) =>
      Object.assign(window, { detail }),
    ),
  )
  await figure.getByRole('slider').last().press('ArrowRight')
  const values = await figure.evaluate(
    (element) => (element as unknown as SlideFigureElement).values,
  )
  expect(values).toMatchObject({ step: 0.41 })
  const told = await page.evaluate(() => (window as unknown as { detail: unknown }).detail)
  expect(told).toEqual(values)
})

test('markup may come first or last, and stand in a shadow root', async () => {
  const { page, problems } = await openHost('<slide-lab compact></slide-lab><div id="card"></div>')
  await spread(page)
  await page.evaluate(() => {
    const late = document.createElement('slide-lab')
    late.setAttribute('compact', '')
    late.setAttribute('fps', '20 40')
    document.querySelector('#card')!.attachShadow({ mode: 'open' }).append(late)
  })
  const inner = page.locator('#card slide-lab')
  await inner.getByRole('button', { name: 'Located' }).click()
  expect(await inner.locator('.sheet').evaluate((sheet) => getComputedStyle(sheet).overflow)).toBe(
    'clip',
  )
  await expect.poll(() => inner.locator('.spread output').innerText()).toMatch(/^0/)
  // Each has its own state.
  expect(await spread(page)).toBe('0.23\u202fm')
  expect(problems).toEqual([])
})

test('keys, menus and links work as in the lab’s own page', async () => {
  const { page, problems } = await openHost('<slide-lab></slide-lab>')
  await page.getByRole('button', { name: 'Theirs' }).focus()
  await page.keyboard.press('Tab')
  const isIn = () => page.evaluate(() => document.activeElement!.localName)
  expect(await isIn()).toBe('slide-lab')
  const playing = () =>
    lab(page).evaluate((element) => (element as unknown as SlideLabElement).playback.playing)
  const field = lab(page).locator('slide-quantity-control input').first()
  await field.focus()
  await page.keyboard.press('Space')
  expect(await playing()).toBe(false)
  await lab(page).locator('.modes .about').click()
  await page.keyboard.press('Space')
  expect(await playing()).toBe(true)
  await page.keyboard.press('Space')
  await page.getByRole('button', { name: 'Share' }).click()
  const downloads = [page.waitForEvent('download')] as const
  await page.getByRole('button', { name: 'Save picture (PNG)' }).click()
  expect((await downloads[0]).suggestedFilename()).toMatch(/\.png$/)
  await page.getByRole('button', { name: 'Theirs' }).click()
  expect(await page.getByRole('button', { name: 'Save picture (PNG)' }).isVisible()).toBe(false)
  expect(problems).toEqual([])
})

test('the link to the lab leads to where the module is from', async () => {
  const { page } = await openHost('<slide-lab compact fps="20 40"></slide-lab>')
  const link = page.getByRole('link', { name: 'Open in the lab' })
  expect(await link.getAttribute('href')).toMatch(/\/blog\/index\.html#runners=20\/.*;40\//)
})

test('where there is no lab beside the file, no link leads there until the page says where', async () => {
  const { page } = await openHost('<slide-lab compact></slide-lab>', { beside: false })
  const link = page.getByRole('link', { name: 'Open in the lab' })
  await page.locator('slide-lab [part=link]').waitFor()
  await page.waitForLoadState('networkidle')
  expect(await link.count()).toBe(0)
  // As text, since Vitest would put an import of its own there.
  const tell = (folder: string | null) =>
    page.evaluate(
      `import('./slide-lab.js').then(({ setSite }) => setSite(${JSON.stringify(folder)}))`,
    )
  await tell('https://example.org/lab/')
  expect(await link.getAttribute('href')).toBe('https://example.org/lab/index.html')
  await tell(null)
  await expect.poll(() => link.count()).toBe(0)
})

test('what is added and removed leaves nothing behind', async () => {
  const { page, problems } = await openHost('<div id="here"></div>')
  const session = await page.context().newCDPSession(page)
  const left = () =>
    page.evaluate(
      () =>
        (window as unknown as { refs: WeakRef<object>[] }).refs.filter((ref) => ref.deref()).length,
    )
  await page.evaluate(async () => {
    await customElements.whenDefined('slide-lab')
    const here = document.querySelector('#here')!
    const refs: WeakRef<object>[] = []
    for (let i = 0; i < 6; i++) {
      for (const name of ['slide-lab', 'slide-figure']) {
        const element = document.createElement(name)
        element.setAttribute('name', 'area-under-v')
        here.append(element)
        refs.push(new WeakRef(element))
      }
      await new Promise((done) => setTimeout(done, 100))
      // Moved, it lives on.
      here.prepend(here.lastElementChild!)
      await new Promise((done) => setTimeout(done, 50))
      here.replaceChildren()
    }
    Object.assign(window, { refs })
  })
  expect(await page.evaluate(() => (window as unknown as { refs: object[] }).refs.length)).toBe(12)
  await expect
    .poll(
      async () => {
        await session.send('HeapProfiler.collectGarbage')
        return left()
      },
      { timeout: 15_000 },
    )
    .toBe(0)
  expect(problems).toEqual([])
})

test('axe finds nothing in a page with both', async () => {
  const { page } = await openHost(
    '<slide-lab></slide-lab><slide-figure name="area-under-v"></slide-figure>',
  )
  await page.locator('slide-figure').scrollIntoViewIfNeeded()
  await page.locator('slide-figure [live]').waitFor()
  expect(await violationsOn(page, 'slide-lab', 'slide-figure')).toEqual([])
})
