import type { Download, FrameLocator, Page } from 'playwright-core'
import { describe, expect, inject, test } from 'vitest'
import type { SlideLabElement } from '../../src/elements.ts'
import { parseExperiment } from '../../src/physics/index.ts'
import { readAddress } from '../../src/lab/state/address.ts'
import { toCsv, toJson } from '../../src/panels/share/texts.ts'
import { Simulation } from '../../src/lab/state/simulation.ts'
import type { LabState } from '../../src/lab/state/state.ts'
import { builtElements, serve } from './hosts.ts'
import { openLab } from './labPage.ts'
import type { Lab } from './labPage.ts'
import { Picture } from './picture.ts'

async function openSharing(address = '', options: Parameters<typeof openLab>[1] = {}) {
  const lab = await openLab(address, options)
  await lab.page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
  await lab.page.getByRole('button', { name: 'Share' }).click()
  return lab
}
const item = (lab: Lab, name: string) => lab.page.getByRole('button', { name })
const status = (lab: Lab) => lab.page.locator('slide-share-menu [role="status"]')
const clipboard = (lab: Lab) => lab.page.evaluate(() => navigator.clipboard.readText())

async function copied(lab: Lab, name: string): Promise<string> {
  await item(lab, name).click()
  await expect.poll(() => status(lab).innerText()).toBe('Copied.')
  return clipboard(lab)
}

async function saved(lab: Lab, name: string): Promise<{ download: Download; content: Buffer }> {
  const waiting = lab.page.waitForEvent('download')
  await item(lab, name).click()
  const download = await waiting
  const parts: Buffer[] = []
  for await (const part of await download.createReadStream()) parts.push(part as Buffer)
  expect(await status(lab).innerText()).toBe(`Saved as ${download.suggestedFilename()}`)
  return { download, content: Buffer.concat(parts) }
}

test('a copied link opens what is shown, at once after a change', async () => {
  const lab = await openSharing('', { width: 1440 })
  await lab.slider('Angle').fill('39')
  await lab.slider('Angle').fill('40')
  await lab.slider('Angle').fill('41')
  await lab.page.getByRole('button', { name: 'Share' }).click()
  const link = await copied(lab, 'Copy link')
  expect(link).toBe(`${inject('address')}lab.html#angle=41`)
  const other = await openLab(new URL(link).hash.slice(1))
  expect(await other.state()).toEqual(await lab.state())
})

describe('embed code, pasted into a page of another origin, shows the figure running:', () => {
  const shown = 'scene=spring&angle=12&runners=15;60/rk4'

  async function pasted(form: 'frame' | 'HTML' | 'Markdown, MDX', module = '') {
    const lab = await openSharing(shown)
    const { page } = lab
    const code = await copied(lab, `Copy embed code: ${form}`)
    const blog = await serve(() => ({
      body: `<!doctype html><html lang="en"><meta charset="utf-8"><title>Blog</title><p>Look:</p>${code}</html>`,
    }))
    // The module is built apart from the page.
    const headers = { 'Access-Control-Allow-Origin': '*' }
    await page.route(new URL('slide-lab.js', inject('address')).href, (route) =>
      route.fulfill({ contentType: 'text/javascript', body: module, headers }),
    )
    await page.goto(blog)
    const problems = () => lab.problems.filter((each) => !each.includes(blog))
    return { page, problems, expected: toJson(readAddress(shown)) }
  }

  /** It stands at the start, and moves on when it is played. */
  async function expectToRun(place: Page | FrameLocator) {
    await place.getByRole('button', { name: 'To the start' }).click()
    const time = () => place.getByRole('slider', { name: 'Time', exact: true }).inputValue()
    expect(await time()).toBe('0')
    await place.getByRole('button', { name: 'Play' }).click()
    await expect.poll(async () => Number(await time())).toBeGreaterThan(0)
    expect(await place.locator('slide-stage canvas').evaluate(countColours)).toBeGreaterThan(50)
  }

  test('frame', async () => {
    const { page, problems, expected } = await pasted('frame')
    const frame = page.frameLocator('iframe[title^="Any Frame Rate: spring"]')
    await frame.locator('[part=link]').waitFor()
    const state = await frame.locator('slide-lab').evaluate((lab) => (lab as unknown as Lab_).state)
    expect(toJson(state)).toBe(expected)
    await expectToRun(frame)
    // The script beside it has given it the figure's height.
    expect(
      await frame.locator('html').evaluate((html) => html.scrollHeight === window.innerHeight),
    ).toBe(true)
    // Sandboxed as it is, it can still keep its address.
    await frame.getByRole('button', { name: 'Located' }).click()
    const open = page.waitForEvent('popup')
    await frame.getByRole('link', { name: 'Open in the lab' }).click()
    const opened = await open
    await opened.locator('slide-lab .runners').waitFor()
    expect(opened.url()).toContain('index.html#scene=spring&angle=12&runners=15;60')
    // Fonts and all came through the sandbox.
    expect(problems()).toEqual([])
  })

  test.each(['HTML', 'Markdown, MDX'] as const)('%s', async (form) => {
    const { page, problems, expected } = await pasted(form, builtElements().module)
    await page.locator('slide-lab [part=link]').waitFor()
    const shown = await page
      .locator('slide-lab')
      .evaluate((lab) => (lab as unknown as SlideLabElement).experiments as unknown[])
    expect(shown).toEqual(JSON.parse(expected))
    await expectToRun(page)
    expect(problems()).toEqual([])
  })
})

test('JSON can be copied, and read back', async () => {
  const lab = await openSharing('angle=20&runners=10;jitter(fps:30,amount:0.5,seed:1)/rk4')
  const text = await copied(lab, 'Copy as JSON')
  const experiments = JSON.parse(text) as unknown[]
  expect(experiments.map(parseExperiment).length).toBe(2)
  expect(text).toBe(toJson(await lab.state()))
})

test('where the page may not write to the clipboard, the text is there to be copied by hand', async () => {
  const lab = await openSharing()
  await lab.page.evaluate(() =>
    Object.defineProperty(navigator, 'clipboard', { value: undefined, configurable: true }),
  )
  await item(lab, 'Copy link').click()
  const field = lab.page.getByRole('textbox', { name: 'Text to copy' })
  const address = `${inject('address')}lab.html`
  expect(await field.inputValue()).toBe(address)
  expect(await status(lab).innerText()).toContain('Copy it by hand')
  await expect.poll(() => lab.page.evaluate(() => getSelection()!.toString())).toBe(address)
  expect(lab.problems).toEqual([])
})

test('the data that is saved is all that was simulated', async () => {
  const lab = await openSharing('scene=run-out&runners=10;60/fixed(step:1/50)')
  const { download, content } = await saved(lab, 'Save data (CSV)')
  const { runners, exact } = new Simulation().run(await lab.state())
  expect(content.toString('utf8')).toBe(toCsv(runners, exact))
  expect(download.suggestedFilename()).toMatch(
    /^any-frame-rate-run-out-runners-10-60-fixed.*\.csv$/,
  )
})

test.each([1, 2])('the picture that is saved is the stage, %d pixels to a pixel', async (ratio) => {
  const lab = await openSharing('angle=20', { deviceScaleFactor: ratio })
  const box = (await lab.page.locator('slide-stage canvas').boundingBox())!
  const { download, content } = await saved(lab, 'Save picture (PNG)')
  expect(download.suggestedFilename()).toBe('any-frame-rate-ramp-angle-20.png')
  expect(content.subarray(1, 4).toString()).toBe('PNG')
  expect(content.readUInt32BE(16)).toBe(Math.round(ratio * box.width))
  expect(content.readUInt32BE(20)).toBe(Math.round(ratio * box.height))
  expect(new Picture(content)).toEqual(await lab.pixels())
  const colours = await lab.page.locator('slide-stage canvas').evaluate(countColours)
  expect(colours).toBeGreaterThan(50)
})

test('where the browser hides what canvases hold, no noise is saved as a picture', async () => {
  const lab = await openSharing()
  // As protection against fingerprinting does it: some of the lowest bits are others.
  await lab.page.evaluate(() => {
    const { getImageData } = CanvasRenderingContext2D.prototype
    CanvasRenderingContext2D.prototype.getImageData = function (...given) {
      const image = getImageData.apply(this, given)
      for (let i = 0; i < image.data.length; i += 40) image.data[i]! ^= 1
      return image
    }
  })
  let downloads = 0
  lab.page.on('download', () => downloads++)
  await item(lab, 'Save picture (PNG)').click()
  await expect.poll(() => status(lab).innerText()).toMatch(/^Nothing is saved: .* screenshot\.$/)
  expect(downloads).toBe(0)
  expect(lab.problems).toEqual([])
})

test('the menu closes with Escape, and when something else is used', async () => {
  const lab = await openSharing()
  const link = item(lab, 'Copy link')
  await lab.page.keyboard.press('Tab')
  await lab.page.keyboard.press('Escape')
  expect(await link.isVisible()).toBe(false)
  expect(await lab.page.locator(':focus').innerText()).toBe('Share')
  await lab.page.keyboard.press('Enter')
  expect(await link.isVisible()).toBe(true)
  await lab.page.getByRole('heading', { level: 1 }).click()
  expect(await link.isVisible()).toBe(false)
  await lab.page.getByRole('button', { name: 'Share' }).click()
  await lab.slider('Angle').focus()
  expect(await link.isVisible()).toBe(false)
})

type Lab_ = { state: LabState }

function countColours(element: Element): number {
  const { width, height } = element as HTMLCanvasElement
  const context = (element as HTMLCanvasElement).getContext('2d')!
  return new Set(new Uint32Array(context.getImageData(0, 0, width, height).data.buffer)).size
}
