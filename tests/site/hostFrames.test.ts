import type { Frame, Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import { scrollThrough } from './frames.ts'
import { builtElements, openAt, serve, serveSite } from './hosts.ts'

/* embed.html in other people's pages: from another origin, sandboxed, and under a policy that forbids what it can. */

const { module } = builtElements()

const SANDBOX = 'sandbox="allow-scripts"'

/** A page of another origin, with frames of the site in it. */
async function openHost(
  body: (site: string) => string,
  {
    headers = {},
    root = '',
    ...options
  }: Parameters<typeof openAt>[2] & {
    headers?: Record<string, string>
    root?: string
  } = {},
) {
  const site = await serveSite(module)
  const html = `<!doctype html><html lang="en" ${root}><title>Blog</title><body style="background: rgb(255, 217, 160)">${body(site)}</body></html>`
  const host = await serve(() => ({ body: html, headers }))
  return { site, ...(await openAt(host, [site], options)) }
}

const frameOf = (site: string, more = '') =>
  `<iframe src="${site}embed.html${more}" title="A figure" width="100%" height="640" frameborder="0" ${SANDBOX}></iframe>`
const resize = (site: string) => `<script src="${site}embed-resize.js" async></script>`

/** The frame, once the figure in it is there. */
async function figureIn(page: Page): Promise<Frame> {
  await page.frameLocator('iframe').first().locator('slide-lab [part=link]').waitFor()
  return page.frames().find((each) => each.url().includes('embed.html'))!
}

const isFitted = (frame: Frame) =>
  frame.evaluate(() => {
    const { scrollHeight, scrollWidth, dataset } = document.documentElement
    return dataset.fitted === '' && scrollHeight === innerHeight && scrollWidth === innerWidth
  })

test('a frame takes the height of the figure, and follows it', async () => {
  const { page, problems } = await openHost((site) => frameOf(site, '#angle=20') + resize(site), {
    width: 1200,
  })
  const frame = await figureIn(page)
  await expect.poll(() => isFitted(frame)).toBe(true)
  const height = () => page.locator('iframe').evaluate((each) => each.clientHeight)
  const wide = await height()
  await page.setViewportSize({ width: 390, height: 800 })
  await expect.poll(async () => (await height()) !== wide && (await isFitted(frame))).toBe(true)
  // Something wrong has its message above the figure.
  const before = await height()
  await page.locator('iframe').evaluate((each) => {
    ;(each as HTMLIFrameElement).src = (each as HTMLIFrameElement).src.replace('=20', '=200')
  })
  await expect.poll(height).toBeGreaterThan(before)
  await expect.poll(async () => isFitted(await figureIn(page))).toBe(true)
  expect(problems()).toEqual([])
})

test('a frame that comes later, and one in a page without an origin', async () => {
  const { page, problems } = await openHost((site) => resize(site) + '<div></div>', {
    headers: { 'Content-Security-Policy': 'sandbox allow-scripts' },
  })
  const site = (await page.locator('script').getAttribute('src'))!.replace('embed-resize.js', '')
  await page.locator('div').evaluate((div, html) => (div.innerHTML = html), frameOf(site))
  await expect.poll(async () => isFitted(await figureIn(page))).toBe(true)
  expect(problems()).toEqual([])
})

test('only the page that it is in gets an answer, and only if it asks', async () => {
  const { page } = await openHost(
    (site) => `<script>
        window.told = []
        addEventListener('message', ({ data, origin }) => told.push({ data, origin }))
      </script>${frameOf(site)}
      <iframe id="other" srcdoc="<script>
        window.told = []
        addEventListener('message', ({ data }) => told.push(data))
      </script>"></iframe>`,
  )
  const frame = await figureIn(page)
  const other = page.frames().find((each) => each.url() === 'about:srcdoc')!
  const told = (where: Page | Frame) =>
    where.evaluate(() => (window as unknown as { told: unknown[] }).told)
  /** Messages are handed over in turn: when one that is sent later has come, those before have. */
  const settle = async () => {
    await frame.evaluate(() => parent.postMessage('settled', '*'))
    await expect.poll(() => told(page)).toContainEqual({ data: 'settled', origin: 'null' })
  }
  await other.evaluate(() => parent.frames[0]!.postMessage({ type: 'any-frame-rate:hello' }, '*'))
  await frame.evaluate(() => window.postMessage({ type: 'any-frame-rate:hello' }, '*'))
  await page.evaluate(() => {
    for (const data of [null, 'hello', {}, { type: 'hello' }]) frames[0]!.postMessage(data, '*')
  })
  await settle()
  expect(await told(page)).toEqual([{ data: 'settled', origin: 'null' }])
  expect(await told(other)).toEqual([])
  expect(await isFitted(frame)).toBe(false)
  await page.evaluate(() => frames[0]!.postMessage({ type: 'any-frame-rate:hello' }, '*'))
  await expect.poll(() => told(page)).toHaveLength(2)
  const [, answer] = (await told(page)) as { data: { type: string; height: number } }[]
  expect(answer).toEqual({
    data: { type: 'any-frame-rate:height', height: answer!.data.height },
    origin: 'null',
  })
  expect(answer!.data.height).toBe(
    await frame.evaluate(() =>
      Math.ceil(document.querySelector('main')!.getBoundingClientRect().height),
    ),
  )
})

test('the page takes a height from the frame alone, and only one that can be', async () => {
  const { page } = await openHost(
    (site) => `${resize(site)}${frameOf(site)}<iframe id="other" srcdoc="<p>Other</p>"></iframe>`,
  )
  const frame = await figureIn(page)
  await expect.poll(() => isFitted(frame)).toBe(true)
  const height = () =>
    page
      .locator('iframe')
      .first()
      .evaluate((each) => each.clientHeight)
  const before = await height()
  const other = page.frames().find((each) => each.url() === 'about:srcdoc')!
  const say = (from: Frame, data: unknown) =>
    from.evaluate((data) => parent.postMessage(data, '*'), data as null)
  await page.evaluate(() => {
    Object.assign(window, { heard: 0 })
    addEventListener('message', () => (window as unknown as { heard: number }).heard++)
  })
  await say(other, { type: 'any-frame-rate:height', height: 77 })
  const odd = [77.5, 0, -5, 1e6, '77', NaN, null]
  for (const height of odd) await say(frame, { type: 'any-frame-rate:height', height })
  for (const data of [null, 'x', { height: 77 }]) await say(frame, data)
  await expect
    .poll(() => page.evaluate(() => (window as unknown as { heard: number }).heard))
    .toBe(odd.length + 4)
  expect(await height()).toBe(before)
  await say(frame, { type: 'any-frame-rate:height', height: 777 })
  await expect.poll(height).toBe(777)
})

describe('the page shows through around the figure', () => {
  const HOST = '255,217,160'

  test.each([
    ['', 'light', 'light'],
    ['', 'dark', 'light'],
    ['color-scheme: dark', 'light', 'dark'],
    ['color-scheme: light dark', 'dark', 'dark'],
  ] as const)('page: %j, system: %s', async (style, colorScheme, expected) => {
    const { page } = await openHost((site) => frameOf(site) + resize(site), {
      root: `style="${style}"`,
      colorScheme,
    })
    const frame = await figureIn(page)
    await expect.poll(() => isFitted(frame)).toBe(true)
    const { x, y } = (await page.locator('iframe').boundingBox())!
    // Outside the card's round corner, as it is on the screen.
    const corner = async () => {
      const png = await page.screenshot({ clip: { x, y, width: 2, height: 2 } })
      return page.evaluate(
        async (data) => {
          const bitmap = await createImageBitmap(await (await fetch(data)).blob())
          const one = new OffscreenCanvas(2, 2).getContext('2d', { willReadFrequently: true })!
          one.drawImage(bitmap, 0, 0)
          return [...one.getImageData(0, 0, 1, 1).data].slice(0, 3).join()
        },
        `data:image/png;base64,${png.toString('base64')}`,
      )
    }
    await expect.poll(corner).toBe(HOST)
    const scheme = await frame.evaluate(
      () => getComputedStyle(document.documentElement).colorScheme,
    )
    expect(scheme).toBe(expected)
  })
})

describe('under a strict Content-Security-Policy', () => {
  /** What pages and frames tell of their policies being broken. */
  async function openStrict(address: string, site: string) {
    const opened = await openAt('about:blank', [site])
    const { page } = opened
    const broken: string[] = []
    await page.exposeFunction('tellBroken', (what: string) => broken.push(what))
    await page.addInitScript(() =>
      addEventListener(
        'securitypolicyviolation',
        ({ effectiveDirective, blockedURI, sourceFile }) =>
          (window as unknown as { tellBroken: (what: string) => void }).tellBroken(
            `${effectiveDirective} ${blockedURI} ${sourceFile}`,
          ),
      ),
    )
    await page.goto(address)
    return { ...opened, broken }
  }

  test.each(['', 'embed.html', 'embed.html#angle=200', '404.html'])(
    'the site’s own /%s',
    async (path) => {
      const site = await serveSite(module)
      const { page, problems, broken } = await openStrict(site + path, site)
      if (path !== '404.html') {
        await page.getByRole('button', { name: 'Located' }).first().click()
        await page.getByRole('button', { name: 'To the start' }).first().click()
        await page.getByRole('button', { name: 'Play' }).first().click()
      }
      await scrollThrough(page)
      expect(broken).toEqual([])
      expect(problems()).toEqual([])
    },
  )

  test('the elements in somebody’s strict page', async () => {
    const site = await serveSite(module)
    const host = await serve(() => ({
      body: `<!doctype html><html lang="en"><title>Blog</title><slide-lab></slide-lab>
        <slide-figure name="area-under-v"></slide-figure><slide-figure name="speed-against-error"></slide-figure>
        <script type="module" src="${site}slide-lab.js"></script></html>`,
      // Not even styles of its own; the arrow of a menu is a picture in the elements' styles.
      headers: {
        'Content-Security-Policy': `default-src 'none'; script-src ${site}; img-src data:`,
      },
    }))
    const { page, problems, broken } = await openStrict(host, site)
    await page.locator('slide-runner-row').first().waitFor()
    await page.locator('slide-lab').getByRole('button', { name: 'Located' }).click()
    await page.locator('slide-lab').getByRole('checkbox', { name: 'Show forces' }).check()
    await scrollThrough(page)
    await page.locator('slide-figure [live]').last().waitFor()
    expect(broken).toEqual([])
    expect(problems().filter((each) => !each.includes(host))).toEqual([])
  })

  test('a frame that may do nothing but run scripts, in a page that may hardly do more', async () => {
    const site = await serveSite(module)
    const host = await serve(() => ({
      body: `<!doctype html><html lang="en"><title>Blog</title>${frameOf(site)}${resize(site)}</html>`,
      headers: {
        'Content-Security-Policy': `default-src 'none'; script-src ${site}; frame-src ${site}`,
      },
    }))
    const { page, problems, broken } = await openStrict(host, site)
    const frame = await figureIn(page)
    const isDenied = () => {
      try {
        return localStorage.length < 0
      } catch {
        return true
      }
    }
    expect(await frame.evaluate(isDenied)).toBe(true)
    await expect.poll(() => isFitted(frame)).toBe(true)
    await frame.getByRole('button', { name: 'Located' }).click()
    await frame.getByRole('button', { name: 'To the start' }).click()
    await frame.getByRole('button', { name: 'Play' }).click()
    await expect
      .poll(() => frame.getByRole('slider', { name: 'Time', exact: true }).inputValue())
      .not.toBe('0')
    expect(broken).toEqual([])
    expect(problems().filter((each) => !each.includes(host))).toEqual([])
  })
})
