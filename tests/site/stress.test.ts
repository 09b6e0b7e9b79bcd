import { expect, test } from 'vitest'
import { readAddress } from '../../src/lab/state/address.ts'
import { experimentOf } from '../../src/lab/state/check.ts'
import type { Change } from '../../src/lab/state/change.ts'
import { integrators, scenes, simulate } from '../../src/physics/index.ts'
import { isLong, samples } from '../samples.ts'
import { openLab } from './labPage.ts'

type Lab = HTMLElement & {
  duration: number
  change: (change: Change) => string
  playback: { time: number; playing: boolean; seek: (time: number) => void }
  trajectories: readonly { frames: number; s: Float64Array }[]
}

const EIGHT = 'duration=10&runners=10;30;60;120;144;240;240/fixed(step:1/60);1/rk4'

test('a tab that was hidden for an hour goes on where it was', async () => {
  const { page, now, problems } = await openLab(EIGHT, { ownClock: true })
  await page.clock.pauseAt(new Date(Date.now() + 1000))
  await page.getByRole('button', { name: 'Play', exact: true }).click()
  await page.clock.runFor(1000)
  const before = await now()
  expect(before).toBeGreaterThan(0.5)
  expect(before).toBeLessThan(1.1)
  // A hidden tab gets no animation frame; the one after it comes an hour later.
  await page.clock.fastForward('01:00:00')
  const after = await now()
  expect(after - before).toBeGreaterThanOrEqual(0)
  // No longer than the longest frame that playback takes at its word, and one more.
  expect(after - before).toBeLessThan(0.12)
  await page.clock.runFor(20_000)
  expect(await now()).toBe(10)
  await page.getByRole('button', { name: 'Play', exact: true }).waitFor()
  expect(problems).toEqual([])
})

test('sizes in a row leave the picture that the last one has', async () => {
  const { page, pixels, problems } = await openLab(EIGHT)
  await pixels()
  const keep = () =>
    page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('slide-stage canvas')!
      const { width, height } = canvas
      const copy = new OffscreenCanvas(width, height)
      const context = copy.getContext('2d', { willReadFrequently: true })!
      context.drawImage(canvas, 0, 0)
      const now = context.getImageData(0, 0, width, height).data
      const kept = window as unknown as { first?: Uint8ClampedArray }
      const first = (kept.first ??= now)
      // The most that any channel of any pixel differs by.
      return now.length === first.length
        ? now.reduce((most, value, i) => Math.max(most, Math.abs(value - first[i]!)), 0)
        : 255
    })
  expect(await keep()).toBe(0)
  await page.setViewportSize({ width: 700, height: 800 })
  await expect.poll(keep).toBe(255)
  for (let i = 0; i < samples(40, 200); i++)
    await page.setViewportSize({ width: 320 + ((i * 137) % 1100), height: 500 + ((i * 71) % 500) })
  await page.setViewportSize({ width: 1280, height: 800 })
  // On a canvas that has had another size, Chromium sets dashes with a last bit more or less of grey.
  await expect.poll(keep, { timeout: 10_000 }).toBeLessThanOrEqual(1)
  expect(problems).toEqual([])
})

test('a thousand changes as fast as they come leave the lab of the last one', async () => {
  const { page, state, address, problems } = await openLab(EIGHT)
  await page.evaluate(
    ({ sceneIds, methods }) => {
      const lab = document.querySelector<Lab>('slide-lab')!
      for (let i = 0; i < 1000; i++) {
        const kinds: Change[] = [
          { kind: 'parameters', values: { gravity: 5 + (i % 100) / 10 } },
          { kind: 'duration', duration: 1 + (i % 7) },
          { kind: 'runner', index: 0, values: { integrator: methods[i % methods.length]! } },
          { kind: 'scene', scene: sceneIds[i % sceneIds.length]! },
          { kind: 'add' },
          { kind: 'remove', index: i % 8 },
          { kind: 'mode', mode: i % 2 ? 'located' : 'clamped' },
        ]
        lab.change(kinds[i % kinds.length]!)
      }
      lab.change({ kind: 'scene', scene: 'half-pipe' })
      lab.change({ kind: 'parameters', values: { radius: 5 } })
    },
    { sceneIds: scenes.map(({ id }) => id), methods: integrators.map(({ id }) => id) },
  )
  await address(/scene=half-pipe&radius=5/)
  const last = await state()
  const shown = await page.evaluate(() =>
    document.querySelector<Lab>('slide-lab')!.trajectories.map(({ s }) => Array.from(s)),
  )
  const expected = last.runners.map((runner) => Array.from(simulate(experimentOf(last, runner)).s))
  expect(shown).toEqual(expected)
  // The address, read again, is the same lab: undo has nothing of the storm left half done.
  const hash = await page.evaluate(() => decodeURIComponent(location.hash.slice(1)))
  expect(readAddress(hash)).toEqual(last)
  expect(problems).toEqual([])
})

test('eight runners of the longest run there is are shown and can be searched', async () => {
  // A million frames each, the most that are allowed.
  const eight = Array.from({ length: 8 }, () => '1').join(';')
  const { page, now, problems, runner } = await openLab(`duration=1000000&runners=${eight}`)
  const frames = await page.evaluate(() =>
    document.querySelector<Lab>('slide-lab')!.trajectories.map((each) => each.frames),
  )
  expect(frames).toEqual(Array.from({ length: 8 }, () => 1_000_000))
  await page.getByRole('slider', { name: 'Time', exact: true }).press('Home')
  expect(await now()).toBe(0)
  await page.getByRole('button', { name: 'One frame forward' }).click()
  expect(await now()).toBe(1)
  await page.getByRole('slider', { name: 'Time', exact: true }).press('End')
  expect(await now()).toBe(1_000_000)
  expect(await runner(7).innerText()).toMatch(/0.69\ss · 1.72\sm/)
  expect(problems).toEqual([])
})

test('zoom and pixel ratio may change while it plays', async () => {
  const { page, now, pixels, problems } = await openLab(EIGHT)
  const session = await page.context().newCDPSession(page)
  const zoom = (deviceScaleFactor: number, zoomed = 1) =>
    session.send('Emulation.setDeviceMetricsOverride', {
      width: Math.round(1280 / zoomed),
      height: Math.round(800 / zoomed),
      deviceScaleFactor: deviceScaleFactor * zoomed,
      mobile: false,
    })
  await page.getByRole('button', { name: 'Play', exact: true }).click()
  for (const [ratio, zoomed] of [
    [2, 1],
    [1.25, 1],
    [1, 2],
    [2.5, 1.5],
    [0.5, 1],
    [1, 1],
  ] as const) {
    const before = await now()
    await zoom(ratio, zoomed)
    await expect.poll(now).toBeGreaterThan(before)
    // As many device pixels as the canvas covers, up to four a pixel: crisp.
    await expect
      .poll(() =>
        page.evaluate(() => {
          const canvas = document.querySelector<HTMLCanvasElement>('slide-stage canvas')!
          return canvas.width - Math.round(canvas.clientWidth * devicePixelRatio)
        }),
      )
      .toBe(0)
  }
  await page.getByRole('button', { name: 'Pause' }).click()
  const time = await now()
  const seen = await pixels()
  const fresh = await openLab(EIGHT)
  await fresh.page.evaluate(
    (time) => document.querySelector<Lab>('slide-lab')!.playback.seek(time),
    time,
  )
  expect(await fresh.pixels()).toEqual(seen)
  expect(problems).toEqual([])
})

test.runIf(isLong)('after many changes of scene the memory is what it was', async () => {
  const { page, problems } = await openLab(EIGHT)
  const session = await page.context().newCDPSession(page)
  const used = async () => {
    for (let i = 0; i < 3; i++) await session.send('HeapProfiler.collectGarbage')
    const { usedSize, backingStorageSize = 0 } = (await session.send('Runtime.getHeapUsage')) as {
      usedSize: number
      backingStorageSize?: number
    }
    return (usedSize + backingStorageSize) / 1e6
  }
  const sceneIds = scenes.map(({ id }) => id)
  const round = (times: number) =>
    page.evaluate(
      async ({ sceneIds, times }) => {
        const lab = document.querySelector<Lab>('slide-lab')!
        for (let i = 0; i < times; i++) {
          lab.change({ kind: 'scene', scene: sceneIds[i % sceneIds.length]! })
          await new Promise(requestAnimationFrame)
        }
      },
      { sceneIds, times },
    )
  // The first rounds load what is loaded late, compile it, and fill the history, which keeps 200 changes.
  await round(250)
  const before = await used()
  // A change that leaves its runs behind adds half a megabyte.
  await round(200)
  expect(Math.abs((await used()) - before)).toBeLessThan(5)
  expect(problems).toEqual([])
})
