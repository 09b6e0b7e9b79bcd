import { expect, test } from 'vitest'
import { initialValues } from '../../src/figures/shared/control.ts'
import { figures } from '../../src/figures/index.ts'
import { openingView } from '../../src/figures/shared/still.ts'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openFigures } from './figurePage.ts'
import { framesAsked, outOfSight } from './frames.ts'

const ids = figures.map(({ id }) => id)

test('every figure comes alive when it comes near, shows what it opens with, and says it', async () => {
  const site = await openFigures(ids)
  for (const { id, load } of figures) {
    const element = await site.see(id)
    const figure = await load()
    expect(await site.values(id)).toEqual(initialValues(figure.controls))
    const { values, runs, time } = openingView(figure)
    // The same steps in Node as in the page, bit for bit, or the words would differ.
    expect((await site.says(id)).replace(/\s+/g, ' ')).toBe(
      figure.says(values, runs, time).replace(/\s+/g, ' '),
    )
    expect(await element.getAttribute('aria-label')).toBe(figure.title)
    expect(await site.time(id)).toBe(time)
  }
  site.expectNoProblems()
})

test('the letter of a coefficient stands below it', async () => {
  const site = await openFigures(['critical-angle'])
  const element = await site.see('critical-angle')
  expect(await element.locator('.slider sub').allTextContents()).toEqual(['s'])
})

test('every control works by keyboard, changes the picture or the words, and is told', async () => {
  const site = await openFigures(ids)
  for (const { id, load } of figures) {
    const { controls } = await load()
    const element = await site.see(id)
    for (const [name, control] of Object.entries(controls)) {
      if (control.hidden || control.type === 'frames') continue
      // Of two that hang together, the one would hide what the other does.
      await site.set(id, initialValues(controls))
      const before = [await site.pixels(id), await element.innerText()].join()
      if (control.type === 'number') {
        await element.locator(`#${id}-${name}`).focus()
        await site.page.keyboard.press('ArrowRight')
        expect((await site.values(id))[name]).toBeCloseTo(control.initial + control.step, 9)
        await site.page.keyboard.press('End')
        expect((await site.values(id))[name]).toBe(control.to)
      } else if (control.type === 'choice') {
        if (control.menu) await element.locator(`#${id}-${name}`).focus()
        else await element.getByRole('radio', { checked: true, name: labelOf(control) }).focus()
        await site.page.keyboard.press('ArrowDown')
        expect((await site.values(id))[name]).not.toBe(control.initial)
      } else {
        await element.getByRole('checkbox', { name: control.label }).focus()
        await site.page.keyboard.press('Space')
        expect((await site.values(id))[name]).toBe(!control.initial)
      }
      const after = [await site.pixels(id), await element.innerText()].join()
      expect(after, `${id} ${name}`).not.toBe(before)
      expect((await site.changes()).at(-1)![name]).toEqual((await site.values(id))[name])
    }
  }
  site.expectNoProblems()
})

function labelOf({
  options,
  initial,
}: {
  options: readonly { id: string; label: string }[]
  initial: string
}): string {
  return options.find(({ id }) => id === initial)!.label
}

test('grips can be dragged and moved by keys', async () => {
  const names = ['forces-on-slope', 'area-under-v', 'where-does-it-stop']
  const site = await openFigures(names)
  for (const name of names) {
    const element = await site.see(name)
    const grip = element.locator('.grip')
    const control = (await grip.getAttribute('data-control'))!
    const from = (await site.values(name))[control] as number
    const { x, y, width, height } = (await grip.boundingBox())!
    await site.page.mouse.move(x + width / 2, y + height / 2)
    await site.page.mouse.down()
    await site.page.mouse.move(x + width / 2 + 40, y + height / 2 - 60, { steps: 4 })
    const dragged = (await site.values(name))[control] as number
    expect(dragged).toBeGreaterThan(from)
    // The grip is where it was dragged to, or as near as its way allows.
    const now = (await grip.boundingBox())!
    if (name !== 'forces-on-slope') expect(now.x - x).toBeCloseTo(40, -1)
    await site.page.mouse.up()
    await site.page.mouse.move(10, 10)
    expect((await site.values(name))[control]).toBe(dragged)
    await grip.focus()
    await site.page.keyboard.press('ArrowLeft')
    expect((await site.values(name))[control]).toBeLessThan(dragged)
    await site.page.keyboard.press('Home')
    expect((await site.values(name))[control]).toBe(
      Number(await grip.getAttribute('aria-valuemin')),
    )
  }
  site.expectNoProblems()
})

test('a finger drags a grip without scrolling the page', async () => {
  const site = await openFigures(['forces-on-slope'], { width: 390, hasTouch: true })
  const element = await site.see('forces-on-slope')
  const { x, y, width, height } = (await element.locator('.grip').boundingBox())!
  const scrolled = () => site.page.evaluate(() => scrollY)
  const before = await scrolled()
  const session = await site.page.context().newCDPSession(site.page)
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', dy: number) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: type === 'touchEnd' ? [] : [{ x: x + width / 2, y: y + height / 2 + dy }],
    })
  await touch('touchStart', 0)
  for (let dy = 8; dy <= 48; dy += 8) await touch('touchMove', dy)
  await touch('touchEnd', 48)
  expect((await site.values('forces-on-slope')).angle).toBeLessThan(25)
  expect(await scrolled()).toBe(before)
  site.expectNoProblems()
})

test('set wakes a figure that is far away, takes text, and refuses what can’t be', async () => {
  const site = await openFigures(['falling-ball', 'three-stops', 'chatter'])
  expect(await site.figure('chatter').getAttribute('live')).toBeNull()
  await site.set('chatter', { fps: '60', stopping: 'clamped' })
  await expect.poll(() => site.values('chatter')).toEqual({ fps: 60, stopping: 'clamped' })
  expect(await site.changes()).toEqual([{ fps: 60, stopping: 'clamped' }])
  await expect(site.set('chatter', { speed: 3 })).rejects.toThrow('no control “speed”')
  await expect(site.set('chatter', { stopping: 'soon' })).rejects.toThrow('no value of')
  expect(await site.values('chatter')).toEqual({ fps: 60, stopping: 'clamped' })
  site.expectNoProblems()
})

test('playing rests off screen, goes on there, and what was paused stays paused', async () => {
  const site = await openFigures(['flung-out', 'falling-ball'])
  const pipe = await site.see('flung-out')
  await pipe.getByRole('button', { name: 'Play' }).click()
  await expect.poll(() => site.time('flung-out')).toBeGreaterThan(0.2)
  await site.see('falling-ball')
  await outOfSight(pipe)
  const left = await site.time('flung-out')
  await site.page.waitForTimeout(300)
  expect(await site.time('flung-out')).toBe(left)
  await pipe.scrollIntoViewIfNeeded()
  await expect.poll(() => site.time('flung-out')).toBeGreaterThan(left)
  await pipe.getByRole('button', { name: 'Pause' }).click()
  const paused = await site.time('flung-out')
  await site.see('falling-ball')
  await outOfSight(pipe)
  await pipe.scrollIntoViewIfNeeded()
  await site.page.waitForTimeout(200)
  expect(await site.time('flung-out')).toBe(paused)
  site.expectNoProblems()
})

test('nothing asks for frames while nothing moves', async () => {
  const site = await openFigures(ids.slice(0, 4))
  for (const id of ids.slice(0, 4)) await site.see(id)
  await expect.poll(() => framesAsked(site.page)).toBe(0)
})

test('the bet: place the flag, run, and be told', async () => {
  const site = await openFigures(['where-does-it-stop'])
  const figure = await site.see('where-does-it-stop')
  await site.set('where-does-it-stop', { bet: 4.4 })
  await figure.getByRole('button', { name: 'Run' }).click()
  await expect.poll(() => site.says('where-does-it-stop')).toBe('It runs …')
  await expect.poll(() => site.says('where-does-it-stop'), { timeout: 8000 }).toMatch(/^You hit it/)
  await figure.locator('.grip').focus()
  await site.page.keyboard.press('ArrowRight')
  expect(await site.says('where-does-it-stop')).toContain('press Run')
  site.expectNoProblems()
})

test('your-frames records the frames of this browser', async () => {
  const site = await openFigures(['your-frames'])
  const figure = await site.see('your-frames')
  await figure
    .locator('slide-frames-recorder')
    .evaluate((each) => Object.assign(each, { length: 0.4 }))
  await figure.getByRole('button', { name: 'Record' }).click()
  await expect.poll(() => site.says('your-frames'), { timeout: 5000 }).toContain('Your browser')
  const { frames } = await site.values('your-frames')
  const total = (frames as number[]).reduce((a, b) => a + b, 0)
  // Until the first frame after it.
  expect(total).toBeGreaterThan(0.39)
  expect(total).toBeLessThan(1.5)
  site.expectNoProblems()
})

test.each(
  some(
    [320, 390, 1280].flatMap((width) => [
      { width, colorScheme: 'light' as const },
      { width, colorScheme: 'dark' as const },
    ]),
    ...[1, 4],
  ),
)(
  'at $width px in the $colorScheme theme axe finds nothing, and nothing is cut off',
  async ({ width, colorScheme }) => {
    const site = await openFigures(ids, { width, colorScheme, hasTouch: width < 800 })
    for (const id of ids) await site.see(id)
    expect(await site.page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    expect(await violationsOn(site.page, 'main')).toEqual([])
    // Every figure has the height that was kept for it before it was there.
    const overfull = await site.page.evaluate(() =>
      [...document.querySelectorAll('slide-figure')].flatMap((figure) => {
        const below = figure.querySelector<HTMLElement>('.below')!
        const room = Number.parseFloat(getComputedStyle(below).minHeight)
        return below.offsetHeight > room + 1
          ? [`${figure.getAttribute('name')} ${below.offsetHeight - room}`]
          : []
      }),
    )
    expect(overfull).toEqual([])
    site.expectNoProblems()
  },
)
