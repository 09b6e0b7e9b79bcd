import { expect, inject, test } from 'vitest'
import { framesAsked } from './frames.ts'
import { openPage } from './page.ts'

interface Sample {
  time: number
  spread: string
  /** Where the number and the picture stand. */
  places: string
}

/**
 * Opens the page and notes what it shows at every frame; `touch` is done to the picture once it has played 0.2 s, and the
 * panels are sent when `panels` says so.
 */
async function watchOpening({
  hash = '',
  touch = '',
  reducedMotion = 'no-preference' as 'reduce' | 'no-preference',
  panels = Promise.resolve(),
} = {}) {
  const { page } = await openPage({ path: '404.html', reducedMotion, height: 1000 })
  await page.route(/instruments/, (route) => panels.then(() => route.continue()))
  await page.addInitScript((touch) => {
    type Shown = HTMLElement & { playback: { time: number } }
    const samples: Sample[] = []
    let touched = false
    let stopped = false
    Object.assign(window, { samples, stopSampling: () => (stopped = true) })
    const sample = () => {
      const lab = document.querySelector<Shown>('slide-lab')
      const canvas = lab?.querySelector('canvas')
      if (lab?.playback && canvas) {
        const number = lab.querySelector('.spread output')!
        const tops = [number, canvas].map((each) => each.getBoundingClientRect())
        samples.push({
          time: lab.playback.time,
          spread: (number as HTMLElement).innerText,
          places: tops.map(({ right, top }) => `${right} ${top}`).join(', '),
        })
        if (touch && !touched && lab.playback.time > 0.2 && lab.playback.time < 1) {
          touched = true
          canvas.dispatchEvent(new Event(touch, { bubbles: true }))
        }
      }
      if (!stopped) requestAnimationFrame(sample)
    }
    requestAnimationFrame(sample)
  }, touch)
  await page.goto(new URL(hash, inject('address')).href)
  await page.locator('slide-stage canvas').waitFor()
  const samples = () => page.evaluate(() => (window as unknown as { samples: Sample[] }).samples)
  return { page, samples }
}

const end = { time: 1, spread: '0.23\u202fm' }

/** The samples from the first that is not at the end. */
const played = (samples: Sample[]) => {
  const first = samples.findIndex(({ time }) => time < end.time)
  return first < 0 ? [] : samples.slice(first)
}

test('what was out of sight meanwhile shows the end too', async () => {
  const { page } = await openPage({ opening: true, height: 500 })
  const ofEnd = await page.locator('.runner .end output').allInnerTexts()
  expect(ofEnd[0]).toBe('−0.246\u202fm')
  await expect
    .poll(() => page.locator('.runner .now output').allInnerTexts(), { timeout: 10_000 })
    .toEqual(ofEnd)
})

test('the blocks run once, then the number counts up, and then nothing moves', async () => {
  const { page, samples } = await watchOpening()
  await expect
    .poll(async () => played(await samples()).at(-1), { timeout: 10_000 })
    .toMatchObject(end)
  const seen = played(await samples())
  const times = seen.map(({ time }) => time)
  expect(times).toEqual([...times].sort((a, b) => a - b))
  expect(times[0]).toBeLessThan(0.2)
  const numbers = seen.map(({ spread }) => parseFloat(spread))
  expect(numbers).toEqual([...numbers].sort((a, b) => a - b))
  expect(new Set(seen.filter(({ time }) => time < 1).map(({ spread }) => spread))).toEqual(
    new Set(['0.00\u202fm']),
  )
  expect(new Set(numbers).size).toBeGreaterThan(2)
  expect(new Set(seen.map(({ places }) => places)).size).toBe(1)
  // The text is laid out once nothing moves.
  await page.locator('.text > section:last-of-type.laid-out').waitFor()
  await page.evaluate(() => (window as unknown as { stopSampling: () => void }).stopSampling())
  await expect.poll(() => framesAsked(page)).toBe(0)
})

test.each(['pointerdown', 'keydown', 'wheel'])('a %s on the lab ends it at once', async (touch) => {
  const { page, samples } = await watchOpening({ touch })
  await expect.poll(async () => played(await samples()).at(-1)).toMatchObject(end)
  await page.waitForTimeout(500)
  const seen = played(await samples())
  const last = seen.map(({ time }) => time < 1).lastIndexOf(true)
  expect(seen[last]!.time).toBeGreaterThan(0.2)
  for (const each of seen.slice(last + 1)) expect(each).toMatchObject(end)
})

test.each([false, true])(
  'it waits for the panels; touched before they are there: %s',
  async (touched) => {
    let send!: () => void
    const { page, samples } = await watchOpening({
      panels: new Promise((resolve) => (send = resolve)),
    })
    await page.waitForTimeout(500)
    if (touched) await page.locator('slide-stage canvas').dispatchEvent('wheel')
    expect(played(await samples())).toEqual([])
    expect((await samples()).at(-1)).toMatchObject(end)
    send()
    await page.locator('slide-lab-plots').waitFor({ state: 'attached' })
    if (!touched) return expect.poll(async () => played(await samples()).length).toBeGreaterThan(1)
    await page.waitForTimeout(500)
    expect(played(await samples())).toEqual([])
  },
)

test('with reduced motion it stands at its end', async () => {
  const { page, samples } = await watchOpening({ reducedMotion: 'reduce' })
  await page.waitForTimeout(500)
  expect(played(await samples())).toEqual([])
  expect((await samples()).at(-1)).toMatchObject(end)
})

test('a link to an experiment shows the end of it', async () => {
  const { page, samples } = await watchOpening({ hash: '#angle=14' })
  await page.waitForTimeout(500)
  expect((await samples()).length).toBeGreaterThan(5)
  expect(played(await samples())).toEqual([])
})
