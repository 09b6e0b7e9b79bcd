import { chromium } from 'playwright-core'
import type { Browser, BrowserContextOptions, Page } from 'playwright-core'
import { inject, onTestFinished } from 'vitest'

type PageOptions = {
  /** Relative to the site, e.g. `embed.html#…`. */
  path?: string
  /** In CSS pixels. */
  width?: number
  height?: number
  deviceScaleFactor?: number
  colorScheme?: 'light' | 'dark'
  reducedMotion?: 'reduce' | 'no-preference'
  hasTouch?: boolean
  /** Of the browser, as `de-DE`. */
  locale?: string
  javaScriptEnabled?: boolean
  /** Leaves the opening playing, which a touch ends otherwise. */
  opening?: boolean
  /** The page's clock is the test's, who may halt it and let hours pass: `page.clock`. */
  ownClock?: boolean
}

type OpenPage = {
  page: Page
  /** Everything that went wrong since the page was opened: messages, exceptions, requests. */
  problems: string[]
  /** Closes the page before its test ends. */
  close: () => Promise<void>
}

let connection: Promise<Browser> | undefined

/** The browser: one connection for all files of a worker, which ends with it. */
export const connected = (): Promise<Browser> =>
  (connection ??= chromium.connect(inject('browser')))

/** Opens a page of the site in a fresh context, loaded and with its fonts. It is closed with its test. */
export async function openPage(options: PageOptions = {}): Promise<OpenPage> {
  const {
    path = '',
    width = 1280,
    height = 800,
    ownClock = false,
    opening = false,
    ...others
  } = options
  const settings: BrowserContextOptions = { viewport: { width, height }, ...others }
  const context = await (await connected()).newContext(settings)
  const close = () => context.close()
  onTestFinished(close)

  const page = await context.newPage()
  const problems = watch(page)
  if (ownClock) await page.clock.install()
  await page.goto(new URL(path, inject('address')).href, { waitUntil: 'load' })
  await page.evaluate(() => document.fonts.ready.then(() => undefined))
  if (options.javaScriptEnabled !== false) {
    await whole(page, opening)
  }
  return { page, problems, close }
}

/**
 * Waits for what a page loads as soon as its lab is alive. Unless its opening is to play, nothing moves from then on, and
 * the text is laid out: at once, and not in frames that have time left.
 */
async function whole(page: Page, opening: boolean): Promise<void> {
  await page.waitForFunction((opening) => {
    const lab = document.querySelector('slide-lab')
    if (!opening) lab?.dispatchEvent(new Event('wheel'))
    const later = lab?.hasAttribute('compact') ? '.open-in-lab' : 'slide-lab-plots:defined'
    const figures =
      !document.querySelector('.tutorial') || document.querySelector('slide-figure:defined')
    return (!lab || lab.querySelector(later)) && figures
  }, opening)
  if (opening) return
  await page.evaluate(async () => {
    for (const section of document.querySelectorAll('.text > section')) {
      section.classList.add('laid-out')
    }
    // What follows from it, the width of an equation for one, is seen to in the next frame.
    await new Promise((then) => requestAnimationFrame(() => requestAnimationFrame(then)))
  })
}

function watch(page: Page): string[] {
  const problems: string[] = []
  const site = inject('address')
  page.on('console', (message) => {
    if (message.type() === 'error' || message.type() === 'warning') {
      problems.push(`console ${message.type()}: ${message.text()}`)
    }
  })
  page.on('pageerror', (error) => problems.push(`exception: ${error.stack ?? error.message}`))
  page.on('requestfailed', (request) => {
    const { errorText = '' } = request.failure() ?? {}
    // A page that is left gives up what it was still loading.
    if (errorText !== 'net::ERR_ABORTED')
      problems.push(`request failed: ${request.url()} ${errorText}`)
  })
  page.on('response', (response) => {
    if (response.status() >= 400) problems.push(`${response.status()}: ${response.url()}`)
  })
  page.on('request', (request) => {
    const url = request.url()
    if (!url.startsWith(site) && !/^(data|blob):/.test(url)) {
      problems.push(`request leaves the site: ${url}`)
    }
  })
  return problems
}
