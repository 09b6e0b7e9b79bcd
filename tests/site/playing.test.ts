import { expect, test } from 'vitest'
import { openLab } from './labPage.ts'
import { Picture } from './picture.ts'

const RUNNERS = '10;30;60;120;144;240;240/fixed(step:1/60);jitter(fps:200,amount:0.5,seed:1)'

/** Eight runners of ten seconds. */
const EIGHT = `duration=10&runners=${RUNNERS}`

type Lab = HTMLElement & { playback: { time: number; seek: (time: number) => void } }
type Watched = Window & { pending: Set<number>; shifts: number; mutated: string[]; errors: number }

test('no animation frame is asked for while nothing moves', async () => {
  const { page, now } = await openLab('duration=2')
  // The lab has been at rest when it was opened: what asks from here on is counted.
  await page.evaluate(() => {
    const { requestAnimationFrame: ask, cancelAnimationFrame: cancel } = window
    const pending = ((window as unknown as Watched).pending = new Set())
    window.requestAnimationFrame = (callback) => {
      const id = ask((time) => {
        pending.delete(id)
        callback(time)
      })
      pending.add(id)
      return id
    }
    window.cancelAnimationFrame = (id) => {
      pending.delete(id)
      cancel(id)
    }
  })
  const pending = () => page.evaluate(() => (window as unknown as Watched).pending.size)
  const play = page.getByRole('button', { name: 'Play', exact: true })
  await expect.poll(pending).toBe(0)
  await play.click()
  await expect.poll(now).toBeGreaterThan(0.1)
  expect(await pending()).toBe(1)
  await page.getByRole('button', { name: 'Pause' }).click()
  await expect.poll(pending).toBe(0)
  await play.click()
  await page.evaluate(() => {
    document.querySelector<HTMLElement>('slide-lab')!.style.marginTop = '5000px'
  })
  await expect.poll(pending).toBe(0)
  expect(await now()).toBeLessThan(2)
  await page.evaluate(() => {
    document.querySelector<HTMLElement>('slide-lab')!.style.marginTop = '0'
  })
  await expect.poll(pending).toBe(1)
  await expect.poll(now, { timeout: 8000 }).toBe(2)
  await expect.poll(pending).toBe(0)
})

test('while it plays only the places that follow time change, and nothing is laid out elsewhere', async () => {
  const { page, now, problems } = await openLab(EIGHT, { height: 1600 })
  await page.getByRole('button', { name: 'Play', exact: true }).first().click()
  await expect.poll(now).toBeGreaterThan(0.1)
  await page.evaluate(() => {
    const watched = window as unknown as Watched
    watched.mutated = []
    watched.shifts = watched.errors = 0
    new PerformanceObserver((list) => {
      watched.shifts += list.getEntries().length
    }).observe({ type: 'layout-shift' })
    const follows = [
      ...['.clock span', '.axis input', 'slide-frame-strip .cursor', 'slide-frame-strip .window'],
      ...['slide-frame-strip .enlarged span', 'slide-frame-strip .note', '.runner .now output'],
      'slide-lab-plots',
    ].join()
    new MutationObserver((records) => {
      for (const { target } of records) {
        const element = target instanceof Element ? target : target.parentElement!
        if (element.closest('.runner .now')) watched.errors++
        if (!element.closest(follows)) watched.mutated.push(element.outerHTML.slice(0, 80))
      }
    }).observe(document.body, {
      subtree: true,
      childList: true,
      characterData: true,
      attributes: true,
    })
    const rendered = (element: Element | null, name: string) => {
      const host = element as unknown as { updated: () => void }
      const { updated } = host
      host.updated = function (...changes) {
        watched.mutated.push(`${name} was rendered`)
        updated?.apply(host, changes)
      }
    }
    for (const name of ['slide-lab', 'slide-stage', 'slide-frame-strip', 'slide-runner-row'])
      rendered(document.querySelector(name), name)
  })
  await expect.poll(now, { timeout: 20_000 }).toBeGreaterThan(1.5)
  const { mutated, shifts, errors } = await page.evaluate(() => {
    const { mutated, shifts, errors } = window as unknown as Watched
    return { mutated: [...new Set(mutated)], shifts, errors }
  })
  expect(mutated).toEqual([])
  expect(shifts).toBe(0)
  // It has been looking at what moves.
  expect(errors).toBeGreaterThan(0)
  expect(problems).toEqual([])
})

test.each([
  // So little friction that the block is on its way for all of the ten seconds.
  ['ramp', '&angle=0&muKinetic=0.05&muStatic=0.05'],
  ['spring', ''],
  ['fall', ''],
])(
  '%s: a picture reached by playing is the same as one drawn afresh',
  async (scene, parameters) => {
    const { page, now, pixels } = await openLab(`scene=${scene}${parameters}&${EIGHT}`)
    await page.getByRole('button', { name: 'Play', exact: true }).click()
    await expect.poll(now, { timeout: 20_000 }).toBeGreaterThan(0.5)
    const { time, png } = await page.evaluate(() => ({
      time: document.querySelector<Lab>('slide-lab')!.playback.time,
      png: document.querySelector<HTMLCanvasElement>('slide-stage canvas')!.toDataURL(),
    }))
    const played = new Picture(png)
    const seek = (time: number) =>
      page.evaluate((time) => document.querySelector<Lab>('slide-lab')!.playback.seek(time), time)
    await seek(time)
    expect(await pixels()).toEqual(played)
    // Back from later.
    await seek(10)
    expect(await pixels()).not.toEqual(played)
    await seek(time)
    expect(await pixels()).toEqual(played)
    // At another width and back: everything is laid out and drawn anew.
    await page.setViewportSize({ width: 900, height: 800 })
    await expect.poll(pixels).not.toEqual(played)
    await page.setViewportSize({ width: 1280, height: 800 })
    await expect.poll(pixels).toEqual(played)
  },
)
