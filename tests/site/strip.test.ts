import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openLab } from './labPage.ts'

const LOSSY =
  'scene=half-pipe&duration=3&runners=10/fixed(step:1/60,maxSteps:4);' +
  'hitch(fps:60,every:0.7,length:0.3)/capped(cap:0.05);10/per-frame(step:1/60);30'

test('under a fixed step each lane has its steps on a line of their own', async () => {
  const { page } = await openLab('runners=10/fixed(step:1/20)')
  await expect.poll(() => filled(page, 0)).not.toEqual([])
  const lines = await filled(page, 0)
  // Eleven frames, and under them twenty steps.
  expect(lines).toContain(11)
  expect(lines).toContain(20)
})

test('what the accumulator holds is seen as an area that follows the frames', async () => {
  const areas = async (fps: number) => {
    const { page } = await openLab(`runners=${fps}/fixed(step:1/20)`)
    return page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('slide-frame-strip canvas')!
      const { width, height } = canvas
      const { data } = canvas.getContext('2d')!.getImageData(0, height - 2, width, 1)
      return data.filter((value, i) => i % 4 === 3 && value > 0).length / width
    })
  }
  // At 20 fps nothing is ever left over; at 40 fps half a step, half of the time.
  expect(await areas(20)).toBe(0)
  expect(await areas(40)).toBeCloseTo(0.5, 1)
})

test('time that was lost or went astray is said under its lane, and to screen readers', async () => {
  const { page, time } = await openLab(LOSSY)
  const notes = page.locator('slide-frame-strip .note')
  const texts = await notes.allInnerTexts()
  expect(texts).toHaveLength(3)
  expect(texts[0]).toMatch(/10 fps · Fixed: 1\.00\u202fs lost/)
  expect(texts[1]).toMatch(/Capped: 0\.90\u202fs lost/)
  expect(texts[2]).toMatch(/physics is 2\.50\u202fs behind/)
  await time().fill('1')
  expect(await notes.nth(2).innerText()).toMatch(/physics is 0\.83\u202fs behind/)
  const words = await page.locator('slide-frame-strip .visually-hidden').textContent()
  expect(words).toMatch(/30 frames, 120 physics steps of 16\.7\u202fms/)
  expect(words).toContain('physics is 0.83\u202fs behind')
})

test('where frames are too dense to be seen, the time around the cursor is enlarged', async () => {
  const { page, time } = await openLab('duration=10')
  const range = async () =>
    (await page.locator('.enlarged p span').allInnerTexts()).map((text) => parseFloat(text))
  await time().fill('5')
  const [from, to] = (await range()) as [number, number]
  expect((from + to) / 2).toBeCloseTo(5, 1)
  // Every frame of the fastest runner has twelve pixels.
  const count = await filled(page, 1)
  expect(Math.max(...count)).toBeGreaterThan(120 * (to - from) - 3)
  expect(Math.max(...count)).toBeLessThan(120 * (to - from) + 3)
  await time().fill('0')
  expect((await range())[0]).toBe(0)
  await time().fill('10')
  expect((await range())[1]).toBe(10)
})

test('where they can be seen there is no second view, and the strip is as high at every instant', async () => {
  const { page, time, goTo } = await openLab()
  expect(await page.locator('.enlarged').count()).toBe(0)
  await goTo(`#${LOSSY}`)
  const height = () => page.locator('slide-frame-strip').evaluate((strip) => strip.clientHeight)
  await time().fill('0')
  const before = await height()
  for (const at of ['0.5', '1.5', '3']) {
    await time().fill(at)
    expect(await height()).toBe(before)
  }
})

test.each(
  some(
    [
      [1280, 'light'],
      [1280, 'dark'],
      [390, 'light'],
      [390, 'dark'],
    ] as const,
    ...[0, 3],
  ),
)('%d px wide, %s: axe finds nothing', async (width, colorScheme) => {
  const { page, problems } = await openLab(LOSSY, { width, colorScheme, hasTouch: width < 800 })
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
  expect(await violationsOn(page, 'slide-frame-strip')).toEqual([])
  expect(problems).toEqual([])
})

/** How many separate things each line of pixels of a canvas of the strip has. */
function filled(page: Page, index: number): Promise<number[]> {
  return page.evaluate((index) => {
    const canvas = document.querySelectorAll<HTMLCanvasElement>('slide-frame-strip canvas')[index]!
    const { width, height } = canvas
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, width, height)
    return Array.from({ length: height }, (_, y) => {
      let count = 0
      for (let x = 0, before = false; x < width; x++) {
        const now = data[4 * (y * width + x) + 3]! > 0
        if (now && !before) count++
        before = now
      }
      return count
    })
  }, index)
}
