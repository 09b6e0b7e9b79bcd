import { execFileSync } from 'node:child_process'
import { cpSync, mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { pathToFileURL } from 'node:url'
import type { Page } from 'playwright-core'
import { afterAll, beforeAll, expect, inject, onTestFinished, test } from 'vitest'
import { connected } from './page.ts'

/* The whole page in one file, opened as a reader does who has nothing but that file, and no network. */

const root = join(import.meta.dirname, '../..')
const site = mkdtempSync(join(tmpdir(), 'any-frame-rate-site-'))
const stick = mkdtempSync(join(tmpdir(), 'any-frame-rate-offline-'))
const file = join(stick, 'renamed and moved.html')

/** Writes the one file from the page that all site tests look at. */
function build(to: string, published = './'): void {
  const vite = join(root, 'node_modules/vite/bin/vite.js')
  const options = ['-c', 'vite.offline.config.ts', '--outDir', site, '--logLevel', 'warn']
  execFileSync(process.execPath, [vite, 'build', ...options], {
    cwd: root,
    env: { ...process.env, NODE_ENV: 'production', VITE_SITE: published },
    stdio: ['ignore', 'ignore', 'inherit'],
  })
  cpSync(join(site, 'offline.html'), to)
}

beforeAll(() => {
  cpSync(inject('folder'), site, { recursive: true })
  build(file)
})

afterAll(() => {
  rmSync(site, { recursive: true, force: true })
  rmSync(stick, { recursive: true, force: true })
})

/** The file in a browser without a network, and all that it says on the console or asks for. */
async function openFile(hash = '', path = file) {
  const context = await (
    await connected()
  ).newContext({
    offline: true,
    viewport: { width: 1280, height: 800 },
  })
  onTestFinished(() => context.close())
  const page = await context.newPage()
  const address = `${pathToFileURL(path).href}${hash}`
  const said: string[] = []
  page.on('console', (message) => said.push(`${message.type()}: ${message.text()}`))
  page.on('pageerror', (error) => said.push(error.stack ?? error.message))
  page.on('request', (request) => {
    const url = request.url()
    if (!request.isNavigationRequest() && !/^(data|blob):/.test(url)) said.push(`request: ${url}`)
  })
  await page.goto(address)
  return { page, said, spread: page.locator('slide-lab .spread output').first() }
}

const fonts = (page: Page) =>
  page.evaluate(async () => {
    await document.fonts.ready
    const loaded = [...document.fonts].filter(
      ({ status, family }) => status === 'loaded' && !family.includes('Fallback'),
    )
    return [...new Set(loaded.map(({ family }) => family.replaceAll('"', '')))].sort()
  })

test('it needs no other file, has its fonts, and plays', async () => {
  expect(readdirSync(stick)).toEqual(['renamed and moved.html'])
  const { page, said, spread } = await openFile()
  // The opening counts up to it.
  await expect.poll(() => spread.innerText()).toBe('0.23\u202fm')
  // Those of formulas are asked for when their section is laid out.
  await expect.poll(() => fonts(page)).toEqual(['Inter', 'STIX Two Math', 'STIX Two Text'])
  const time = page.getByRole('slider', { name: 'Time', exact: true }).first()
  await page.getByRole('button', { name: 'To the start' }).first().click()
  expect(await time.inputValue()).toBe('0')
  await page.getByRole('button', { name: 'Play', exact: true }).first().click()
  await expect.poll(async () => Number(await time.inputValue())).toBeGreaterThan(0)
  expect(said).toEqual([])
})

test('what the lab shows is kept in the address, through a reload', async () => {
  const { page, said, spread } = await openFile()
  await page.getByRole('button', { name: 'Located' }).click()
  await page.getByRole('slider', { name: 'Angle, slider' }).fill('20')
  const hash = () => page.evaluate(() => location.hash)
  await expect.poll(hash).toMatch(/angle=20.*runners=/)
  const before = [await hash(), await spread.innerText()]
  await page.reload()
  await expect.poll(async () => [await hash(), await spread.innerText()]).toEqual(before)
  await page.getByRole('link', { name: 'Any Frame Rate' }).click()
  await expect.poll(() => spread.innerText()).toBe('0.23\u202fm')
  expect(said).toEqual([])
})

test('speed against error is measured in a worker, and the report is there', async () => {
  const { page, said } = await openFile()
  const started = page.waitForEvent('worker')
  await page.locator('slide-lab-measures').evaluate((each) => each.scrollIntoView())
  expect((await started).url()).toMatch(/^blob:/)
  const measured = () =>
    page.evaluate(() => {
      const diagram = document.querySelector('slide-speed-diagram') as unknown as {
        measuring: { done: number }
        swept: Map<string, unknown>
      } | null
      return diagram && diagram.measuring.done === 1 && diagram.swept.size
    })
  await expect.poll(measured, { timeout: 30_000 }).toBeGreaterThan(5)
  expect(page.workers()).toHaveLength(1)
  // The report, which the page on the web fetches.
  await page.locator('slide-measured-report summary').click()
  await page.locator('slide-measured-report table').first().waitFor()
  expect(said).toEqual([])
})

test('a figure of the tutorial answers', async () => {
  const { page, said } = await openFile()
  const figure = page.locator('slide-figure[name="critical-angle"]')
  await figure.scrollIntoViewIfNeeded()
  await figure.and(page.locator('[live]')).waitFor()
  const says = await figure.locator('.says').innerText()
  await figure.locator('input[type="range"]').first().press('End')
  await expect.poll(() => figure.locator('.says').innerText()).not.toBe(says)
  expect(said).toEqual([])
})

test('what is shared from it is what other people can open', async () => {
  const clipboard = async (page: Page, name: string) => {
    await page.evaluate(() =>
      Object.defineProperty(navigator, 'clipboard', {
        value: { writeText: (text: string) => Promise.resolve(void (document.title = text)) },
      }),
    )
    await page.getByRole('button', { name: 'Share', exact: true }).click()
    await page.getByRole('button', { name }).first().click()
    await expect
      .poll(() => page.locator('slide-share-menu [role="status"]').innerText())
      .not.toBe('')
    return [await page.title(), await page.locator('slide-share-menu [role="status"]').innerText()]
  }
  const { page } = await openFile('#angle=20')
  const [, said] = await clipboard(page, 'Copy embed code')
  expect(said).toMatch(/is a file on your computer/)

  const published = join(site, 'published.html')
  build(published, 'https://example.org/lab/')
  const { page: other } = await openFile('#angle=20', published)
  const [link] = await clipboard(other, 'Copy link')
  expect(link).toBe('https://example.org/lab/#angle=20')
})

test('it says nothing of things that a file has not, and the page says its size', () => {
  const html = readFileSync(file, 'utf8')
  const size = `${(statSync(file).size / 1e6).toFixed(1)} MB`
  for (const name of ['README.md', 'index.html'])
    expect(readFileSync(join(root, name), 'utf8').replace(/\s+/g, ' ')).toContain(size)
  expect(html).not.toMatch(/data-online|rel="canonical"|property="og:/)
})
