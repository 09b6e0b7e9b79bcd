import type { Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import { builtElements, openAt, serve, serveSite } from './hosts.ts'

/* Pages whose readers switch the theme, each in the way of one generator of pages: element and frame follow. */

const { module } = builtElements()

/** How a theme is dark, and how its button makes it so. */
const themes = {
  'a scheme, with transitions off while it is switched': {
    css: `[data-theme=dark] { color-scheme: dark } .still, .still * { transition: none !important }`,
    dark: `root.classList.add('still'); root.dataset.theme = 'dark'
      requestAnimationFrame(() => root.classList.remove('still'))`,
  },
  'a scheme, and one of its own for frames': {
    css: `[data-theme=dark] { color-scheme: dark } iframe { color-scheme: light }`,
    dark: `root.dataset.theme = 'dark'`,
  },
  'an attribute of the body, and a background': {
    css: `body { background: white } [data-jp-theme-light=false] { background: rgb(17 17 17) }`,
    dark: `document.body.dataset.jpThemeLight = 'false'`,
  },
  'a class, and a background that gets there by and by': {
    css: `body { background: #fff; transition: background-color 0.2s } .dark body { background: #123 }`,
    dark: `root.classList.add('dark')`,
  },
  'a background in a colour space of its own, around the figure alone': {
    css: `main.night { background: oklch(0.2 0.03 250) }`,
    dark: `document.querySelector('main').classList.add('night')`,
  },
  'another style sheet': {
    css: '',
    dark: `document.head.appendChild(document.createElement('style')).textContent = 'body { background: #000 }'`,
  },
} as const

async function openHost(css: string) {
  const site = await serveSite(module)
  const body = `<!doctype html><html lang="en"><title>Manual</title><style>${css}</style><main>
    <slide-lab compact></slide-lab>
    <iframe src="${site}embed.html" title="A figure" width="100%" height="640" sandbox="allow-scripts"></iframe>
    </main><script type="module" src="${site}slide-lab.js"></script>
    <script src="${site}embed-resize.js"></script></html>`
  const opened = await openAt(await serve(() => ({ body })), [site])
  const { page } = opened
  const sheet = (where: { locator: Page['locator'] }) => () =>
    where
      .locator('slide-lab .sheet')
      .first()
      .evaluate((each) => getComputedStyle(each).backgroundColor)
  return { ...opened, element: sheet(page), frame: sheet(page.frameLocator('iframe') as never) }
}

// From theme.css.
const LIGHT = 'rgb(255, 255, 255)'
const DARK = 'rgb(27, 32, 38)'

describe.each(Object.entries(themes))('%s', (_, { css, dark }) => {
  test('element and frame follow', async () => {
    const { page, element, frame, problems } = await openHost(css)
    await expect.poll(element).toBe(LIGHT)
    await expect.poll(frame).toBe(LIGHT)
    await page.evaluate(`{ const root = document.documentElement; ${dark} }`)
    await expect.poll(element).toBe(DARK)
    await expect.poll(frame).toBe(DARK)
    // Only a frame of the figure's own scheme lets the page show through.
    expect(
      await page.locator('iframe').evaluate((each) => getComputedStyle(each).colorScheme),
    ).toBe('dark')
    expect(problems()).toEqual([])
  })
})

test('a theme that is asked for is stronger than the background', async () => {
  const { page, element } = await openHost('body { background: black }')
  await expect.poll(element).toBe(DARK)
  await page.locator('slide-lab').evaluate((lab) => lab.setAttribute('theme', 'light'))
  await expect.poll(element).toBe(LIGHT)
})

test('a script that a router runs again listens once, and a frame far below is sized before it is seen', async () => {
  const site = await serveSite(module)
  const body = `<!doctype html><html lang="en"><title>Manual</title><script>
      window.listening = 0;
      {
      const { addEventListener } = EventTarget.prototype
      EventTarget.prototype.addEventListener = function (type, ...more) {
        if (type === 'message' && this === window) listening++
        return addEventListener.call(this, type, ...more)
      }
      }
    </script><div style="height: 20000px"></div>
    <iframe src="${site}embed.html" title="A figure" width="100%" height="100" loading="lazy" sandbox="allow-scripts"></iframe>
    <script src="${site}embed-resize.js"></script></html>`
  const { page, problems } = await openAt(await serve(() => ({ body })), [site])
  const height = () => page.locator('iframe').evaluate(({ clientHeight }) => clientHeight)
  await expect.poll(height).toBeGreaterThan(400)
  // All of it, with what comes last.
  const own = () =>
    page
      .frameLocator('iframe')
      .locator('main')
      .evaluate((main) => Math.ceil(main.getBoundingClientRect().height))
  await page.frameLocator('iframe').locator('[part=link]').waitFor()
  await expect.poll(async () => (await height()) - (await own())).toBe(0)
  expect(await page.evaluate(() => scrollY)).toBe(0)
  for (let i = 0; i < 3; i++) await page.addScriptTag({ url: `${site}embed-resize.js` })
  expect(await page.evaluate(() => (window as unknown as { listening: number }).listening)).toBe(1)
  expect(problems()).toEqual([])
})
