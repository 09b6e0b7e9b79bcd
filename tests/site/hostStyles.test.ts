import type { Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import { figure, lab, openHost } from './hostPage.ts'

/* The elements in pages with styles of their own: neither changes the other's look. */

test.each([
  ...['display: flex', 'display: inline-block', 'display: table', 'float: left'],
  ...['position: absolute', 'width: max-content', 'display: grid; grid-template-columns: auto 1fr'],
])('in a place that asks how wide they are, by %s, there is something to see', async (style) => {
  const parts = [lab, figure].map((each) => `<div style="${style}">${each}</div>`).join('')
  const { page } = await openHost(parts, { width: 390 })
  await page.locator('slide-lab .sheet').waitFor()
  const widths = () =>
    page
      .locator('slide-lab, slide-figure')
      .evaluateAll((all) => all.map((each) => each.clientWidth))
  // Four fifths of the window's 390 px, and no more than is there.
  expect(Math.min(...(await widths()))).toBeGreaterThanOrEqual(312)
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390)
  await page.setViewportSize({ width: 1280, height: 800 })
  // The 40 rem of a column of text.
  await expect.poll(async () => Math.min(...(await widths()))).toBe(640)
})

test.each(['zoom: 1.5', 'transform: scale(0.6)'])(
  'what is dragged in a page of %s stays under the finger',
  async (style) => {
    const { page } = await openHost(
      `<div style="width: 600px; transform-origin: 0 0; ${style}">${lab + figure}</div>`,
      {
        height: 1800,
      },
    )
    await page.locator('slide-figure [live]').waitFor()
    for (const [name, x, y] of [
      ['[data-handle=push]', 60, -16],
      ['[data-control=step]', 40, 0],
    ] as const) {
      const handle = page.locator(name)
      const middle = async () => {
        const { x, y, width, height } = (await handle.boundingBox())!
        return { x: x + width / 2, y: y + height / 2 }
      }
      const from = await middle()
      await page.mouse.move(from.x, from.y)
      await page.mouse.down()
      await page.mouse.move(from.x + x, from.y + y, { steps: 4 })
      // A step of what it changes is a few pixels.
      await expect.poll(async () => Math.abs((await middle()).x - from.x - x)).toBeLessThan(6)
      await page.mouse.up()
    }
  },
)

/** The place of everything that is in the elements, relative to them. */
function layout(page: Page) {
  return page.evaluate(() =>
    [...document.querySelectorAll('slide-lab, slide-figure')].flatMap((host) => {
      const { left, top } = host.getBoundingClientRect()
      return [...host.shadowRoot!.querySelectorAll(':not(option)')].map((each) => {
        const box = each.getBoundingClientRect()
        // What is not displayed is nowhere.
        if (each.getClientRects().length === 0) return each.localName
        const place = [box.left - left, box.top - top, box.width, box.height]
        return `${each.localName} ${place.map((value) => Math.round(10 * value) / 10).join(' ')}`
      })
    }),
  )
}

test.each([
  [
    'everything as the browser has it',
    '',
    '* { all: revert !important; } script { display: none !important }',
  ],
  [
    'another size of everything',
    '',
    'html { font-size: 40px } body { font: italic 60px/3 fantasy; }',
  ],
  ['the size of a tenth', '', 'html { font-size: 62.5% }'],
  [
    'letters',
    '',
    '* { letter-spacing: 5px; word-spacing: 1em; text-transform: uppercase; text-indent: 3em; white-space: pre }',
  ],
  [
    'boxes',
    '',
    '* { box-sizing: content-box; padding: 0; border-width: 0 } * > * { line-height: 4 }',
  ],
  ['animations', '', '* { transition: all 3s; animation: none; }'],
  ['from right to left', 'dir="rtl"', ''],
  [
    'variables',
    '',
    ':root { --accent: 1; --size: 99px; --ink: none; --sans: 4; --runner-0: x; --slide-unit: 50px }',
  ],
])('styles of the page that set %s change nothing in the elements', async (_, root, css) => {
  const box =
    '#box { display: block; width: 640px; margin: 0; padding: 0 } #box > * { display: block }'
  const body = `<div id="box">${lab}${figure}</div>`
  const open = async (root: string, css: string) => {
    const { page, problems } = await openHost(body, {
      root,
      head: `<style>${css}</style><style>${box.replaceAll(/; | }/g, ' !important$&')}</style>`,
    })
    await page.locator('slide-figure [live]').waitFor()
    await page.locator('slide-lab [part=link]').waitFor()
    return { page, problems }
  }
  const plain = await open('', '')
  const wild = await open(root, css)
  const expected = await layout(plain.page)
  expect(expected.length).toBeGreaterThan(60)
  await expect.poll(() => layout(wild.page)).toEqual(expected)
  expect(wild.problems()).toEqual([])
})

test('a page from right to left has pictures from left to right', async () => {
  const pictures = async (root: string) => {
    const { page } = await openHost(lab + figure, { root })
    await page.locator('slide-figure [live]').waitFor()
    await page.locator('slide-lab [part=link]').waitFor()
    await page.evaluate(() => document.fonts.ready.then(() => undefined))
    return page
      .locator('slide-stage canvas, slide-figure-picture canvas, slide-frame-strip canvas')
      .evaluateAll((all) => all.map((each) => (each as HTMLCanvasElement).toDataURL()))
  }
  const expected = await pictures('')
  expect(expected.length).toBeGreaterThan(2)
  await expect.poll(() => pictures('dir="rtl"')).toEqual(expected)
})

describe('light and dark', () => {
  const sheet = (page: Page) =>
    page
      .locator('.sheet')
      .first()
      .evaluate((each) => getComputedStyle(each).backgroundColor)
  // From theme.css.
  const LIGHT = 'rgb(255, 255, 255)'
  const DARK = 'rgb(27, 32, 38)'

  /** The colour of the ground in the picture of a lab. */
  const groundOf = (page: Page) =>
    page.locator('slide-stage canvas').evaluate((canvas) => {
      const one = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })!
      one.drawImage(canvas as HTMLCanvasElement, -2, 3 - (canvas as HTMLCanvasElement).height)
      return [...one.getImageData(0, 0, 1, 1).data].join()
    })

  test.each([
    ['', 'light', LIGHT],
    ['', 'dark', LIGHT],
    ['color-scheme: dark', 'light', DARK],
    ['color-scheme: light', 'dark', LIGHT],
    ['color-scheme: light dark', 'light', LIGHT],
    ['color-scheme: light dark', 'dark', DARK],
  ] as const)('in a page of %j and a system of %s', async (style, colorScheme, expected) => {
    const { page } = await openHost(lab, { root: `style="${style}"`, colorScheme })
    await page.locator('.sheet').waitFor()
    expect(await sheet(page)).toBe(expected)
  })

  test('both change with the page, pictures too, and in a shadow root', async () => {
    const { page, problems } = await openHost('<article></article>', { colorScheme: 'light' })
    await page.evaluate((lab) => {
      document.querySelector('article')!.attachShadow({ mode: 'open' }).innerHTML = lab
    }, lab)
    await page.locator('.sheet').waitFor()
    const corner = () => groundOf(page)
    const set = (scheme: string) =>
      page.evaluate((scheme) => (document.documentElement.style.colorScheme = scheme), scheme)
    // The ground, from theme.css.
    await expect.poll(corner).toBe('239,236,228,255')
    await set('dark')
    await expect.poll(() => sheet(page)).toBe(DARK)
    await expect.poll(corner).toBe('36,43,51,255')
    await set('light dark')
    await expect.poll(() => sheet(page)).toBe(LIGHT)
    await page.emulateMedia({ colorScheme: 'dark' })
    await expect.poll(() => sheet(page)).toBe(DARK)
    await page.locator('slide-lab').evaluate((lab) => lab.setAttribute('theme', 'light'))
    await expect.poll(() => sheet(page)).toBe(LIGHT)
    await expect.poll(corner).toBe('239,236,228,255')
    expect(problems()).toEqual([])
  })

  test('a transition that has not got anywhere shows the new colours already', async () => {
    const { page } = await openHost(lab, { root: 'style="color-scheme: light"' })
    await page.locator('.sheet').waitFor()
    const session = await page.context().newCDPSession(page)
    await session.send('Animation.enable')
    await session.send('Animation.setPlaybackRate', { playbackRate: 0 })
    await page.evaluate(() => (document.documentElement.style.colorScheme = 'dark'))
    await expect.poll(() => sheet(page)).toBe(DARK)
  })

  test('what was not displayed when the page changed is as the page when it is shown', async () => {
    const { page } = await openHost(`<section>${lab}</section>`, {
      root: 'style="color-scheme: light"',
    })
    await page.locator('.sheet').waitFor()
    const show = (display: string) =>
      page.evaluate(
        (display) => (document.querySelector('section')!.style.display = display),
        display,
      )
    await show('none')
    await page.evaluate(() => (document.documentElement.style.colorScheme = 'dark'))
    await page.evaluate(() => new Promise(requestAnimationFrame))
    await show('block')
    await expect.poll(() => sheet(page)).toBe(DARK)
  })

  test('paper is light, and there is nothing to press on it', async () => {
    const { page } = await openHost(lab + figure, { root: 'style="color-scheme: dark"' })
    await page.locator('slide-figure [live]').waitFor()
    await page.locator('slide-lab [part=link]').waitFor()
    await expect.poll(() => groundOf(page)).toBe('36,43,51,255')
    const print = (media: 'print' | 'screen', event: string) =>
      page
        .emulateMedia({ media })
        .then(() => page.evaluate((event) => void dispatchEvent(new Event(event)), event))
    const pressed = () => page.locator('button:visible, input:visible, a:visible').count()
    expect(await pressed()).toBeGreaterThan(10)
    await print('print', 'beforeprint')
    await expect.poll(() => sheet(page)).toBe(LIGHT)
    await expect.poll(() => groundOf(page)).toBe('239,236,228,255')
    expect(await pressed()).toBe(0)
    expect(await page.locator('canvas:visible').count()).toBe(2)
    await print('screen', 'afterprint')
    await expect.poll(() => sheet(page)).toBe(DARK)
    await expect.poll(() => groundOf(page)).toBe('36,43,51,255')
    expect(await pressed()).toBeGreaterThan(10)
  })
})
