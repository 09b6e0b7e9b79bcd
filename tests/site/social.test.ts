import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, inject, test } from 'vitest'
import { violationsOn } from './axe.ts'
import { openPage } from './page.ts'

/** What other sites show with a link to this one. `npm run shots` takes it anew from the lab. */
const file = join(import.meta.dirname, '../../public/social.png')

/** The figure on its own, large enough for a thumbnail: its title, its number and its picture. */
const poster = `
  main { padding: 20px 0 0 }
  h1.visually-hidden {
    position: static; width: auto; height: auto; margin: 0 40px; clip-path: none;
    font: 400 48px/1.2 var(--serif)
  }
  html, body { background: var(--paper) !important }
  slide-lab .sheet { min-height: 0 !important; border: 0; border-radius: 0 }
  slide-lab .opening { padding: 6px 40px 10px; border: 0; background: var(--paper) }
  .spread { flex: 1; flex-direction: row; align-items: baseline; justify-content: space-between }
  .spread span { font-size: 24px }
  slide-lab slide-stage { flex: 0 0 366px !important }
  .modes, .transport, .open-in-lab, slide-frame-strip { display: none !important }
`

test.runIf(process.env.SHOTS === 'renew')('a picture of the lab is taken', async () => {
  const { page } = await openPage({
    ...{ path: 'embed.html', width: 960, height: 504, deviceScaleFactor: 1.25 },
    reducedMotion: 'reduce',
  })
  await page.addStyleTag({ content: poster })
  const title = 'Same kick. Same ramp. Three frame rates.'
  await page.locator('h1').evaluate((element, text) => (element.textContent = text), title)
  await page.evaluate(() => new Promise((done) => setTimeout(done, 200)))
  writeFileSync(file, await page.screenshot({ animations: 'disabled' }))
})

test('the page names a picture of the size that it says, and the site has it', async () => {
  const { page, problems } = await openPage()
  const content = (property: string) =>
    page.locator(`meta[property="og:${property}"]`).getAttribute('content')
  const url = new URL((await content('image'))!, inject('address')).href
  const size = await page.evaluate(async (src) => {
    const image = Object.assign(new Image(), { src })
    await image.decode()
    return [image.naturalWidth, image.naturalHeight].map(String)
  }, url)
  expect(size).toEqual([await content('image:width'), await content('image:height')])
  expect((await page.request.get(url)).headers()['content-type']).toBe('image/png')
  // What many sites refuse to fetch.
  expect(readFileSync(file).length).toBeLessThan(300_000)
  expect(problems).toEqual([])
})

test('the page for lost links leads to the lab, with what the link said of it', async () => {
  const { page, problems } = await openPage({ path: '404.html#angle=20' })
  await page.getByRole('link', { name: 'Open the lab with it' }).click()
  await page.locator('slide-runner-row').first().waitFor()
  expect(page.url()).toMatch(/\/#angle=20$/)
  expect(problems).toEqual([])
})

test.each(['light', 'dark'] as const)('axe finds nothing in it, %s', async (colorScheme) => {
  const { page } = await openPage({ path: '404.html#angle=20', colorScheme, width: 320 })
  expect(await violationsOn(page)).toEqual([])
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(320)
})

test('it says nothing of links that say nothing', async () => {
  const { page } = await openPage({ path: '404.html#tutorial' })
  expect(await page.getByRole('link').allInnerTexts()).toEqual([
    'Any Frame Rate',
    'The lab',
    'The tutorial',
  ])
})
