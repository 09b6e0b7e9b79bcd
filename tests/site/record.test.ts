import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { framesAsked } from './frames.ts'
import { openLab } from './labPage.ts'

type Recorder = HTMLElement & {
  source: (callback: (timestamp: number) => void) => () => void
  length: number
}

/** Frames that follow each other at once, as if a 60 Hz display had missed every tenth refresh. */
async function useSteadyFrames(page: Page): Promise<void> {
  await page.evaluate(() => {
    let refresh = 0
    const recorder = document.querySelector('slide-record-frames') as Recorder
    recorder.source = (callback) => {
      const timer = setTimeout(() => {
        refresh += refresh % 10 === 0 ? 2 : 1
        callback((refresh * 1000) / 60)
      })
      return () => clearTimeout(timer)
    }
    recorder.length = 1
  })
}

const parts = (page: Page) => {
  const recorder = page.locator('slide-record-frames')
  return {
    recorder,
    press: (name: string) => recorder.getByRole('button', { name }).click(),
    sample: recorder.locator('.sample'),
  }
}

test('the frames of this browser are recorded, shown, and become the clock of the selected runner', async () => {
  const { page, state, problems, address, runner } = await openLab()
  const { recorder, press, sample } = parts(page)
  await page.evaluate(
    () => ((document.querySelector('slide-record-frames') as Recorder).length = 0.5),
  )
  await runner(1).locator('select').first().focus()
  await press('Record my frames')
  expect(await recorder.getByRole('progressbar').count()).toBe(1)
  await expect.poll(() => sample.count()).toBe(1)
  expect(await sample.innerText()).toMatch(
    /\d+ frames in 0\.\d s, about \d+ Hz: median \d+\.\d ms, 99 % within \d+\.\d ms, longest \d+\.\d ms\./,
  )
  await press('Use for 30 fps')
  const { frames } = (await state()).runners[1]!
  if (frames.kind !== 'recorded') expect.unreachable()
  else {
    expect(frames.durations.length).toBeGreaterThan(2)
    expect(frames.durations.length).toBeLessThan(200)
    for (const each of frames.durations) expect(Math.round(each * 1e4) / 1e4).toBe(each)
    const total = frames.durations.reduce((sum, each) => sum + each, 0)
    expect(total).toBeGreaterThan(0.49)
  }
  await address(/recorded\(durations:/)
  expect(problems).toEqual([])
})

test('a new runner takes the frames, and the link brings them back', async () => {
  const { page, state, address } = await openLab()
  const { press, sample, recorder } = parts(page)
  await useSteadyFrames(page)
  await press('Record my frames')
  await expect.poll(() => sample.count()).toBe(1)
  expect(await sample.locator('p').first().innerText()).toBe(
    '55 frames in 1.0 s, about 60 Hz: median 16.7 ms, 99 % within 33.4 ms, longest 33.4 ms.',
  )
  expect(await recorder.getByRole('img').getAttribute('aria-label')).toContain('median 16.7 ms')
  await recorder.getByText('As a table').click()
  expect(await recorder.locator('tbody td').allInnerTexts()).toEqual(['16–17', '49', '33–34', '6'])
  await press('Use for a new runner')
  await expect
    .poll(() => recorder.getByRole('status').innerText())
    .toBe('A new runner has your frames.')
  const before = await state()
  expect(before.runners).toHaveLength(4)
  expect(before.runners[3]!.frames).toMatchObject({ kind: 'recorded' })
  await address(/recorded\(durations:4n-[a-z0-9_A-Z]+\)/)
  await page.reload()
  await expect.poll(state).toEqual(before)
})

test('it never begins by itself, and can be cancelled', async () => {
  const { page } = await openLab()
  const { recorder, press, sample } = parts(page)
  await useSteadyFrames(page)
  expect(await recorder.getByRole('progressbar').count()).toBe(0)
  await page.evaluate(
    () => ((document.querySelector('slide-record-frames') as Recorder).length = 1000),
  )
  await press('Record my frames')
  await press('Cancel')
  expect(await recorder.getByRole('progressbar').count()).toBe(0)
  expect(await sample.count()).toBe(0)
  await expect.poll(() => framesAsked(page)).toBe(0)
})

test('it stops and says so when the page is hidden', async () => {
  const { page } = await openLab()
  const { recorder, press, sample } = parts(page)
  await press('Record my frames')
  await page.evaluate(() => {
    Object.defineProperty(document, 'hidden', { value: true, configurable: true })
    document.dispatchEvent(new Event('visibilitychange'))
  })
  await expect.poll(() => recorder.getByRole('status').innerText()).toContain('the page was hidden')
  expect(await recorder.getByRole('progressbar').count()).toBe(0)
  expect(await sample.count()).toBe(0)
})

test.each(
  some(
    [
      ['light', 1280],
      ['dark', 320],
    ] as const,
    1,
  ),
)(
  'axe finds nothing in the %s theme, and nothing sticks out at %d px',
  async (colorScheme, width) => {
    const { page, problems } = await openLab('', { colorScheme, width })
    const { press, sample, recorder } = parts(page)
    await page.evaluate(
      () => ((document.querySelector('slide-record-frames') as Recorder).length = 1000),
    )
    await press('Record my frames')
    expect(await violationsOn(page, 'slide-record-frames')).toEqual([])
    await press('Cancel')
    await useSteadyFrames(page)
    await press('Record my frames')
    await expect.poll(() => sample.count()).toBe(1)
    await recorder.getByText('As a table').click()
    expect(await violationsOn(page, 'slide-record-frames')).toEqual([])
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    expect(problems).toEqual([])
  },
)
