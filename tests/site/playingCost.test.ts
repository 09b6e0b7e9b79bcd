import type { CDPSession, Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { openLab } from './labPage.ts'

const RUNNERS = '10;30;60;120;144;240;240/fixed(step:1/60);jitter(fps:200,amount:0.5,seed:1)'

/** Eight runners of ten seconds; on the ramp all of them are on their way for half a second, and rest after one. */
const EIGHT = `duration=10&runners=${RUNNERS}`

type Lab = HTMLElement & {
  playback: { time: number; seek: (time: number) => void; play: () => void; pause: () => void }
}

/** What happened in each of sixty frames of a sixtieth of a second, whatever the machine is busy with. */
type Frame = { readonly changed: number; readonly drawn: number }

/** What a lab asks of its browser, in the hands of a test. */
type Held = Window & { asked: FrameRequestCallback[]; drawn: number; letGo: () => void }

/** Plays a second of a lab from a time on, by a clock of the test's own. */
async function playSecond(page: Page, from: number): Promise<Frame[]> {
  await page.evaluate((from) => {
    const { playback } = document.querySelector<Lab>('slide-lab')!
    const stage = document.querySelector<HTMLCanvasElement>('slide-stage canvas')!
    const held = window as unknown as Held
    const ask = window.requestAnimationFrame
    held.asked = []
    window.requestAnimationFrame = (callback) => held.asked.push(callback)
    const { fill } = CanvasRenderingContext2D.prototype
    CanvasRenderingContext2D.prototype.fill = function (...given: unknown[]) {
      if (this.canvas === stage) held.drawn++
      return Reflect.apply(fill, this, given) as undefined
    }
    held.letGo = () => {
      CanvasRenderingContext2D.prototype.fill = fill
      window.requestAnimationFrame = ask
    }
    playback.seek(from)
    playback.play()
  }, from)
  // What begins with playing is not what each frame costs.
  await page.waitForTimeout(50)
  return page.evaluate(() => {
    const held = window as unknown as Held
    const watching = new MutationObserver(() => {})
    watching.observe(document, {
      ...{ subtree: true, childList: true, characterData: true, attributes: true },
    })
    const frames: Frame[] = []
    for (let i = 0; i < 60; i++) {
      held.drawn = 0
      const due = held.asked
      held.asked = []
      for (const callback of due) callback(1000 + (i * 1000) / 60)
      frames.push({ changed: watching.takeRecords().length, drawn: held.drawn })
    }
    watching.disconnect()
    document.querySelector<Lab>('slide-lab')!.playback.pause()
    held.letGo()
    return frames
  })
}

test('while it plays the page is written ten times a second, and between that nothing of it changes', async () => {
  const { page, now, time } = await openLab(EIGHT)
  await page.locator('.runner .now output').first().waitFor()
  await page.locator('.transport').evaluate((each) => each.scrollIntoView({ block: 'center' }))
  const frames = await playSecond(page, 0.2)
  const writings = frames.filter(({ changed }) => changed > 0)
  expect(writings.length).toBeGreaterThanOrEqual(9)
  expect(writings.length).toBeLessThanOrEqual(11)
  // As soon as it is paused everything says where it is. The first of the frames only tells the time of the clock.
  expect(await now()).toBeCloseTo(0.2 + 59 / 60, 6)
  expect(await page.locator('.transport .clock').innerText()).toBe('1.18 / 10.00 s')
  expect(Number(await time().inputValue())).toBeCloseTo(0.2 + 59 / 60, 6)
})

test('the picture is drawn at every frame in which something in it moves, and at no other', async () => {
  const { page } = await openLab(EIGHT)
  await page.locator('.runner .now output').first().waitFor()
  const moving = await playSecond(page, 0.1)
  // The first only tells the time of the clock.
  expect(moving.slice(1, 25).every(({ drawn }) => drawn > 0)).toBe(true)
  const resting = await playSecond(page, 4)
  expect(resting.slice(1).map(({ drawn }) => drawn)).toEqual(Array(59).fill(0))
  // Its arrows are there as long as they are asked for.
  await page.getByRole('checkbox', { name: 'Show forces' }).check()
  expect((await playSecond(page, 4)).every(({ drawn }) => drawn > 0)).toBe(true)
})

test('what is written has a size of its own: nothing else is laid out with it', async () => {
  const { page, now } = await openLab(EIGHT)
  await page.locator('.runner .now output').first().waitFor()
  await page.locator('.transport').evaluate((each) => each.scrollIntoView({ block: 'center' }))
  const cdp = await page.context().newCDPSession(page)
  const browser = page.context().browser()!
  await page.getByRole('button', { name: 'Play', exact: true }).first().click()
  await expect.poll(now).toBeGreaterThan(0.2)
  await browser.startTracing(page, { categories: ['devtools.timeline'] })
  const from = await now()
  await expect.poll(now, { timeout: 20_000 }).toBeGreaterThan(from + 1.5)
  const laidOut = layoutsOf(await browser.stopTracing(), await frameOf(cdp))
  expect(laidOut.length).toBeGreaterThan(3)
  // Of the thousands of the page. A browser that is busy may have one layout of everything to catch up with.
  const small = laidOut.filter((objects) => objects < 100)
  expect(small.length / laidOut.length).toBeGreaterThan(0.5)
})

test.each([390, 1440])('%d px wide: each part of the page is painted by itself', async (width) => {
  const { page } = await openLab(EIGHT, { width })
  await page.locator('slide-lab-plots').waitFor()
  const together = await page.evaluate(() =>
    [...document.querySelectorAll('slide-lab .sheet > *, main > section, .text > section')]
      // The menus of the masthead lie over what comes after it.
      .filter((each) => !each.matches('.masthead, .tutorial, .visually-hidden'))
      .filter((each) => getComputedStyle(each).isolation !== 'isolate')
      .map((each) => each.outerHTML.slice(0, 60)),
  )
  expect(together).toEqual([])
})

async function frameOf(cdp: CDPSession): Promise<string> {
  return (await cdp.send('Page.getFrameTree')).frameTree.frame.id
}

/** How many objects each layout of a frame had to look at. */
function layoutsOf(trace: Buffer, frame: string): number[] {
  type Event = {
    name: string
    args?: { beginData?: { frame: string; totalObjects: number } }
  }
  const { traceEvents } = JSON.parse(trace.toString()) as { traceEvents: Event[] }
  return traceEvents
    .filter(({ name, args }) => name === 'Layout' && args?.beginData?.frame === frame)
    .map(({ args }) => args!.beginData!.totalObjects)
}
