import type { Page } from 'playwright-core'
import { expect, test } from 'vitest'
import { framesAsked } from './frames.ts'
import { openLab } from './labPage.ts'

type Lab = HTMLElement & { change: (change: object) => string }

/** Sets all runners to a mode; answers whether the blocks are on their way then. */
function setMode(page: Page, mode: string): Promise<boolean> {
  return page.evaluate((mode) => {
    const lab = document.querySelector<Lab>('slide-lab')!
    lab.change({ kind: 'mode', mode })
    return lab.hasAttribute('gliding')
  }, mode)
}

test('the blocks glide to where a button puts them, and end where they belong', async () => {
  const moving = await openLab('', { reducedMotion: 'no-preference' })
  const still = await openLab('', { reducedMotion: 'reduce' })
  const before = await moving.pixels()
  expect(await setMode(moving.page, 'no-delta-time')).toBe(true)
  // The figures do not wait.
  expect((await moving.state()).runners[0]!.timestep.kind).toBe('per-frame')
  expect(await moving.spread()).toBe('0.95\u202fm')
  const after = await moving.pixels()
  expect(after).not.toEqual(before)
  expect(await setMode(still.page, 'no-delta-time')).toBe(false)
  // A picture is drawn in the next frame.
  await expect.poll(() => framesAsked(still.page)).toBe(0)
  await expect.poll(() => framesAsked(moving.page)).toBe(0)
  expect(await moving.pixels()).toEqual(await still.pixels())
})

test('on the way there are pictures that are neither the one nor the other', async () => {
  const { page } = await openLab('', { reducedMotion: 'no-preference' })
  const pictures = await page.evaluate(async () => {
    const lab = document.querySelector<Lab>('slide-lab')!
    const canvas = lab.querySelector('canvas')!
    // A clock of the test's own, so that it does not matter how busy the machine is.
    let now = performance.now()
    let frame: FrameRequestCallback | undefined
    performance.now = () => now
    window.requestAnimationFrame = (callback) => ((frame = callback), 1)
    lab.change({ kind: 'mode', mode: 'no-delta-time' })
    const pictures = []
    while (lab.hasAttribute('gliding')) {
      now += 100
      frame!(now)
      await new Promise((resolve) => setTimeout(resolve, 20))
      pictures.push(canvas.toDataURL())
    }
    return pictures
  })
  expect(pictures.length).toBe(4)
  expect(new Set(pictures).size).toBe(4)
})

test('a change that comes in between ends it, and nothing moves afterwards', async () => {
  const { page } = await openLab('', { reducedMotion: 'no-preference' })
  await setMode(page, 'located')
  const rest = await page.evaluate(async () => {
    const lab = document.querySelector<Lab>('slide-lab')!
    lab.change({ kind: 'parameters', values: { angle: 20 } })
    const gliding = lab.hasAttribute('gliding')
    // What was asked for before is drawn.
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)))
    let count = 0
    window.requestAnimationFrame = () => ++count
    await new Promise((resolve) => setTimeout(resolve, 500))
    return { gliding, count }
  })
  expect(rest).toEqual({ gliding: false, count: 0 })
})

test('a button that changes nothing moves nothing', async () => {
  const { page } = await openLab('', { reducedMotion: 'no-preference' })
  expect(await setMode(page, 'clamped')).toBe(false)
})
