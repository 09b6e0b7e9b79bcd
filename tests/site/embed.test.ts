import { expect, inject, test } from 'vitest'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openPage } from './page.ts'

test('the figure is there, and nothing else', async () => {
  const { page, problems } = await openPage({ path: 'embed.html#angle=20' })
  for (const name of ['Play', 'Clamped', 'Located'])
    expect(await page.getByRole('button', { name }).isVisible()).toBe(true)
  expect(await page.locator('.spread output').innerText()).toMatch(/^0\.\d\d\u202fm$/)
  expect(await page.getByRole('img').getAttribute('aria-label')).toContain('10 fps')
  for (const other of ['header', 'footer', 'slide-runner-row', '.parameters', '.scenes', '.tools'])
    expect(await page.locator(other).count(), other).toBe(0)
  expect(problems).toEqual([])
})

test('its address is that of the lab, and follows it', async () => {
  const { page } = await openPage({ path: 'embed.html#angle=20' })
  await page.getByRole('slider', { name: 'Tilt the track' }).press('ArrowUp')
  const link = page.getByRole('link', { name: 'Open in the lab' })
  expect(await link.getAttribute('href')).toMatch(
    /\/index\.html#angle=20\.\d+$|\/index\.html#angle=21$/,
  )
  const [opened] = await Promise.all([page.waitForEvent('popup'), link.click()])
  await opened.locator('slide-runner-row').first().waitFor()
  expect(opened.url()).toBe(await link.evaluate((element) => (element as HTMLAnchorElement).href))
  await expect.poll(() => page.evaluate(() => location.hash)).toBe(new URL(opened.url()).hash)
})

test('a bad address says what is wrong with it, above a figure that works', async () => {
  const { page } = await openPage({ path: 'embed.html#angle=200' })
  expect(await page.getByRole('alert').innerText()).toContain('200 is not in 0…90')
  expect(await page.locator('.spread output').innerText()).toBe('0.23\u202fm')
})

test('there is no script or style in the page itself, and the page around it shows through', async () => {
  const { page } = await openPage({ path: 'embed.html' })
  const html = await page.evaluate(async () => (await fetch(location.href)).text())
  expect(html).not.toMatch(/<style|<script(?![^>]*\bsrc=)|\son\w+=|\sstyle=/)
  const background = () => getComputedStyle(document.documentElement).backgroundColor
  expect(await page.evaluate(background)).toBe('rgba(0, 0, 0, 0)')
  expect(await page.evaluate(() => getComputedStyle(document.body).backgroundColor)).toBe(
    'rgba(0, 0, 0, 0)',
  )
})

test.each([
  [560, 315, ''],
  [480, 270, '#runners=45/godot;144/unity-update'],
])('in a frame of %d × %d the transport is in view, and a picture', async (width, height, link) => {
  const { page } = await openPage({ path: `embed.html${link}`, width, height })
  const play = (await page.getByRole('button', { name: 'Play' }).boundingBox())!
  expect(play.y + play.height).toBeLessThanOrEqual(height)
  const stage = (await page.locator('slide-stage').boundingBox())!
  expect(stage.height).toBeGreaterThan(100)
  // All of it, above the transport.
  expect(stage.y).toBeGreaterThan(0)
  expect(stage.y + stage.height).toBeLessThanOrEqual(play.y)
  expect(await page.evaluate(() => scrollY)).toBe(0)
})

test('in a frame of 390 × 640 all from the buttons to the clock is in view', async () => {
  const { page } = await openPage({ path: 'embed.html', width: 390, height: 640 })
  for (const part of ['.modes .segments', '.spread', 'slide-stage', '.transport .clock']) {
    const { y, height } = (await page.locator(part).boundingBox())!
    expect(y, part).toBeGreaterThan(0)
    expect(y + height, part).toBeLessThanOrEqual(640)
  }
})

test('where there are no scripts, a still and a link to the lab’s page', async () => {
  const { page } = await openPage({ path: 'embed.html', javaScriptEnabled: false })
  const still = (await page.getByRole('img', { name: /^Ramp/ }).boundingBox())!
  expect(still.width).toBe(1280)
  await page.getByRole('link').click()
  await page.getByRole('heading', { level: 1, name: 'Same kick' }).waitFor()
})

test('its data can be taken from it, by hand where a frame may save no files', async () => {
  const { page } = await openPage({ path: '404.html' })
  await page.setContent(
    `<iframe src="${inject('address')}embed.html" sandbox="allow-scripts" width="700" height="900"></iframe>`,
  )
  const frame = page.frameLocator('iframe')
  await frame.getByRole('button', { name: 'Share' }).click()
  await frame.getByRole('button', { name: 'Save data (CSV)' }).click()
  const text = await frame.getByRole('textbox', { name: 'Text to copy' }).inputValue()
  expect(text.split('\n')[0]).toContain('time (s)')
  expect(text.split('\n').length).toBeGreaterThan(100)
  expect(await frame.locator('slide-share-menu [role=status]').innerText()).toMatch(
    /if this frame may save files/,
  )
})

test.each(
  some(
    [
      [320, 640, 'light'],
      [390, 700, 'dark'],
      [720, 640, 'light'],
      [1200, 640, 'dark'],
    ] as const,
    ...[0, 3],
  ),
)('%d by %d, %s: nothing is cut off, and axe finds nothing', async (width, height, colorScheme) => {
  const { page } = await openPage({ path: 'embed.html', width, height, colorScheme })
  const { scrollWidth, scrollHeight } = await page.evaluate(() => {
    const { scrollWidth, scrollHeight } = document.documentElement
    return { scrollWidth, scrollHeight }
  })
  expect(scrollWidth).toBe(width)
  // The height that the embed code asks for is enough but on phones.
  if (width >= 700) expect(scrollHeight).toBe(height)
  expect((await page.locator('slide-stage').boundingBox())!.height).toBeGreaterThan(230)
  expect(await violationsOn(page)).toEqual([])
})
