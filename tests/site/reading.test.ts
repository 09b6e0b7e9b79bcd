import { describe, expect, test } from 'vitest'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openPage } from './page.ts'
import { alive, valuesOf } from './readingPage.ts'

describe('the text', () => {
  test('has no dead link, no id twice and a title for every section', async () => {
    const { page, problems } = await openPage()
    const { dead, twice, links, titles } = await page.evaluate(() => {
      const ids = [...document.querySelectorAll('[id]')].map(({ id }) => id)
      const anchors = [...document.querySelectorAll<HTMLAnchorElement>('a[href^="#"]')]
      return {
        dead: anchors
          .filter(({ dataset, hash }) => !('lab' in dataset) && !ids.includes(hash.slice(1)))
          .map(({ outerHTML }) => outerHTML),
        twice: ids.filter((id, i) => ids.indexOf(id) !== i),
        links: anchors.length,
        titles: document.querySelectorAll('.text > section > h2').length,
      }
    })
    expect({ dead, twice }).toEqual({ dead: [], twice: [] })
    expect(links).toBeGreaterThan(50)
    expect(titles).toBe(13)
    expect(problems).toEqual([])
  })

  test('stands in one column of about 68 letters on a wide screen', async () => {
    const { page } = await openPage({ width: 1440 })
    const letters = await page.evaluate(() => {
      const counts: number[] = []
      for (const paragraph of document.querySelectorAll('.text > section > p')) {
        const lines = new Map<number, number>()
        const range = document.createRange()
        const texts = document.createTreeWalker(paragraph, NodeFilter.SHOW_TEXT)
        for (let node = texts.nextNode(); node; node = texts.nextNode())
          for (let i = 0; i < node.textContent!.length; i++) {
            range.setStart(node, i)
            range.setEnd(node, i + 1)
            const line = Math.round(range.getBoundingClientRect().bottom / 12)
            lines.set(line, (lines.get(line) ?? 0) + 1)
          }
        // All but the last line of plain paragraphs are full.
        if (!paragraph.querySelector('math, code, .dial'))
          counts.push(...[...lines.values()].slice(0, -1))
      }
      counts.sort((a, b) => a - b)
      return counts[counts.length >> 1]!
    })
    expect(letters).toBeGreaterThanOrEqual(62)
    expect(letters).toBeLessThanOrEqual(72)
  })

  test.each(some([320, 390, 768, 1200, 1440], 0, 2, 3))(
    'does not scroll sideways at %d px',
    async (width) => {
      const { page } = await openPage({ width, height: 800 })
      // Unfolded, so that all of it is measured.
      await page.evaluate(() => {
        for (const details of document.querySelectorAll<HTMLDetailsElement>('.text details'))
          details.open = true
      })
      await page.evaluate(() => new Promise((done) => setTimeout(done, 300)))
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
      // Wherever it is wider than its place, it scrolls there, and keys reach it.
      const wide = await page.evaluate(() =>
        [...document.querySelectorAll<HTMLElement>('.text *')]
          .filter(
            (box) =>
              getComputedStyle(box).overflowX === 'auto' && box.scrollWidth > box.clientWidth,
          )
          .map(
            (box) => box.getAttribute('role') === 'region' && box.tabIndex === 0 && box.ariaLabel,
          ),
      )
      if (width === 320) expect(wide.length).toBeGreaterThan(0)
      expect(wide.every(Boolean)).toBe(true)
    },
  )

  test.each(
    some(
      [
        ['light', 1440],
        ['light', 390],
        ['dark', 1440],
        ['dark', 390],
      ] as const,
      3,
    ),
  )('has nothing that axe finds, %s, %d px', async (colorScheme, width) => {
    const { page } = await openPage({ width, colorScheme })
    expect(await violationsOn(page, '.tutorial')).toEqual([])
  })

  test('is set in the fonts of the page, its maths in the maths font', async () => {
    const { page } = await openPage({ path: '#forces-on-a-slope' })
    await page.locator('.equation math').first().scrollIntoViewIfNeeded()
    const loaded = await page.evaluate(async () => {
      await document.fonts.ready
      return [...document.fonts]
        .filter(({ status }) => status === 'loaded')
        .map(({ family }) => family)
    })
    expect(loaded.map((family) => family.replaceAll('"', ''))).toContain('STIX Two Math')
  })
})

describe('the contents', () => {
  test('know where the reader is', async () => {
    const { page } = await openPage({ width: 1280 })
    const current = page.locator('.contents a[aria-current="location"]')
    for (const id of ['forces-on-a-slope', 'real-frames', 'what-moves']) {
      await page.evaluate((name) => document.getElementById(name)!.scrollIntoView(), id)
      await page.locator(`.contents a[href="#${id}"][aria-current="location"]`).waitFor()
      expect(await current.count()).toBe(1)
    }
    await page.evaluate(() => scrollTo(0, 0))
    await current.waitFor({ state: 'detached' })
  })

  test('stay beside the text on a wide screen', async () => {
    const { page } = await openPage({ width: 1280 })
    const link = page.locator('.contents a[href="#stopping"]')
    await link.scrollIntoViewIfNeeded()
    await link.click()
    await page.locator('.contents a[href="#stopping"][aria-current]').waitFor()
    expect(await link.isVisible()).toBe(true)
    const { y } = (await page.locator('#stopping h2').boundingBox())!
    expect(y).toBeLessThan(400)
  })

  test('open and close on a narrow one', async () => {
    const { page } = await openPage({ width: 390 })
    const link = page.locator('.contents a[href="#stopping"]')
    expect(await link.isVisible()).toBe(false)
    await page.locator('.contents summary').click()
    await link.click()
    await link.waitFor({ state: 'hidden' })
    const { y } = (await page.locator('#stopping h2').boundingBox())!
    expect(Math.abs(y)).toBeLessThan(400)
  })
})

describe('a number of the text', () => {
  async function openDial(options = {}) {
    const opened = await openPage({ width: 1280, ...options })
    await alive(opened.page, 'falling-ball')
    const field = opened.page.locator('.dial[data-figure="falling-ball"][data-control="fps"] input')
    await field.first().scrollIntoViewIfNeeded()
    return { ...opened, field: field.first() }
  }

  test('has a name, and drives its figure by typing and by arrow keys', async () => {
    const { page, field, problems } = await openDial()
    expect(await field.getAttribute('aria-label')).toMatch(/^Frame rate in the figure/)
    await field.fill('30')
    expect((await valuesOf(page, 'falling-ball')).fps).toBe(30)
    await field.press('ArrowUp')
    expect((await valuesOf(page, 'falling-ball')).fps).toBe(31)
    // What is too large is shown as wrong, and then taken back.
    await field.fill('1000')
    expect((await valuesOf(page, 'falling-ball')).fps).toBe(31)
    await field.blur()
    expect(await field.inputValue()).toBe('31')
    expect(problems).toEqual([])
  })

  test('can be dragged', async () => {
    const { page, field } = await openDial()
    const before = Number(await field.inputValue())
    const { x, y, width, height } = (await field.boundingBox())!
    await page.mouse.move(x + width / 2, y + height / 2)
    await page.mouse.down()
    await page.mouse.move(x + width / 2 + 60, y + height / 2, { steps: 5 })
    await page.mouse.up()
    // Six pixels a step.
    expect((await valuesOf(page, 'falling-ball')).fps).toBe(before + 10)
    expect(await field.inputValue()).toBe(String(before + 10))
  })

  test('follows its figure', async () => {
    const { page, field } = await openDial()
    await page.locator('slide-figure[name="falling-ball"]').evaluate((figure) => {
      ;(figure as unknown as { set(values: object): void }).set({ fps: 24 })
    })
    expect(await field.inputValue()).toBe('24')
  })

  test('wakes a figure that is far away', async () => {
    const { page, field } = await openDial({ height: 300 })
    await page.reload()
    await field.evaluate((input: HTMLInputElement) => {
      input.value = '24'
      input.dispatchEvent(new Event('input'))
    })
    await page.locator('slide-figure[name="falling-ball"][live]').waitFor({ state: 'attached' })
    expect((await valuesOf(page, 'falling-ball')).fps).toBe(24)
  })
})

describe('a link', () => {
  test('sets its figure and brings it into view', async () => {
    const { page } = await openPage({ width: 1280, height: 700, reducedMotion: 'reduce' })
    const link = page.locator('a[data-set^="falling-ball?"]').first()
    const [, query] = (await link.getAttribute('data-set'))!.split('?')
    await link.evaluate((a) => {
      a.scrollIntoView({ block: 'start' })
      ;(a as HTMLElement).click()
    })
    await page.locator('slide-figure[name="falling-ball"][live]').waitFor()
    const values = await valuesOf(page, 'falling-ball')
    for (const [name, value] of new URLSearchParams(query)) expect(String(values[name])).toBe(value)
    const { y, height } = (await page.locator('slide-figure[name="falling-ball"]').boundingBox())!
    expect(y + height).toBeGreaterThan(280)
    expect(y).toBeLessThan(420)
    expect(new URL(page.url()).hash).toBe('')
  })

  test('opens an experiment in the lab', async () => {
    const { page, problems } = await openPage()
    const link = page.locator('a[data-lab]').first()
    const address = (await link.getAttribute('href'))!
    await link.click()
    expect(new URL(page.url()).hash).toBe(address)
    expect((await page.locator('#lab').boundingBox())!.y).toBeLessThan(100)
    await page.waitForFunction(() => document.activeElement?.id === 'lab')
    expect(problems).toEqual([])
  })
})

test.each([390, 320])('every equation is whole at %d px', async (width) => {
  const { page } = await openPage({ width })
  const cut = () =>
    page
      .locator('.equation')
      .evaluateAll((all) =>
        all
          .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth + 1)
          .map(({ textContent }) => textContent),
      )
  await expect.poll(cut).toEqual([])
})

test('links at the foot have the colour of links', async () => {
  const { page } = await openPage()
  const colour = (at: string) =>
    page
      .locator(at)
      .first()
      .evaluate((link) => getComputedStyle(link).color)
  expect(await colour('.page-foot a')).toBe(await colour('.text a[href^="https:"]'))
})
