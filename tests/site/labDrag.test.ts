import { describe, expect, test } from 'vitest'
import { middle, openLab } from './labPage.ts'
import type { Lab } from './labPage.ts'
import type { Picture } from './picture.ts'

const TILT = '[data-handle="tilt"]'

/** What must follow a change of the angle: state, field, slider, handle, picture, figures, address. */
async function expectTilted(
  lab: Lab,
  before: { pixels: Picture; spread: string },
): Promise<number> {
  const { angle } = (await lab.state()).parameters as { angle: number }
  expect(angle).not.toBe(15)
  expect(await lab.field('Angle').inputValue()).toBe(String(angle))
  expect(await lab.handle('Tilt the track').getAttribute('aria-valuenow')).toBe(String(angle))
  expect(await lab.handle('Tilt the track').getAttribute('aria-valuetext')).toBe(`${angle} °`)
  expect(await lab.pixels()).not.toEqual(before.pixels)
  expect(await lab.spread()).not.toBe(before.spread)
  await lab.address(new RegExp(`^#angle=${angle}$`))
  expect(lab.problems).toEqual([])
  return angle
}

describe('the end of the ramp', () => {
  test('follows the mouse, and everything follows it', async () => {
    const lab = await openLab()
    const { page } = lab
    const before = { pixels: await lab.pixels(), spread: await lab.spread() }
    await page.locator(TILT).scrollIntoViewIfNeeded()
    const { x, y } = await middle(page, TILT)
    await page.mouse.move(x, y)
    await page.mouse.down()
    const seen: number[] = []
    for (const step of [1, 2, 3, 4]) {
      await page.mouse.move(x - 4 * step, y - 25 * step)
      seen.push((await lab.state()).parameters.angle!)
    }
    await page.mouse.up()
    expect([...seen].sort((a, b) => a - b)).toEqual(seen)
    expect(new Set(seen).size).toBe(4)
    expect(await expectTilted(lab, before)).toBe(seen[3])
    // Once it is let go the mouse is free again.
    await page.mouse.move(x, y + 50)
    expect((await lab.state()).parameters.angle).toBe(seen[3])
  })

  test('does not leap when it is taken hold of beside its middle', async () => {
    const lab = await openLab()
    await lab.page.locator(TILT).scrollIntoViewIfNeeded()
    const { x, y } = await middle(lab.page, TILT)
    await lab.page.mouse.move(x + 12, y + 12)
    await lab.page.mouse.down()
    await lab.page.mouse.move(x + 12, y + 12.4)
    expect(Math.abs((await lab.state()).parameters.angle! - 15)).toBeLessThan(0.6)
  })

  test('follows a finger, and the page keeps still', async () => {
    const lab = await openLab('', { width: 390, height: 844, hasTouch: true })
    const { page } = lab
    const before = { pixels: await lab.pixels(), spread: await lab.spread() }
    await page.locator('slide-stage').evaluate((stage) => stage.scrollIntoView({ block: 'center' }))
    const scrolled = await page.evaluate(() => scrollY)
    const { x, y } = await middle(page, TILT)
    const session = await page.context().newCDPSession(page)
    const touch = (
      type: 'touchStart' | 'touchMove' | 'touchEnd',
      points: { x: number; y: number }[],
    ) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points })
    await touch('touchStart', [{ x, y }])
    for (let i = 1; i <= 6; i++) await touch('touchMove', [{ x, y: y - 10 * i }])
    await touch('touchEnd', [])
    expect(await expectTilted(lab, before)).toBeGreaterThan(15)
    expect(await page.evaluate(() => scrollY)).toBe(scrolled)
  })

  test('follows the keys of a slider, and the cursor on time does not', async () => {
    const lab = await openLab()
    const before = { pixels: await lab.pixels(), spread: await lab.spread() }
    const handle = lab.handle('Tilt the track')
    await handle.focus()
    const angles: number[] = []
    for (const key of [
      'ArrowRight',
      'ArrowUp',
      'Shift+ArrowUp',
      'ArrowLeft',
      'PageDown',
      'End',
      'Home',
    ]) {
      await handle.press(key)
      angles.push((await lab.state()).parameters.angle!)
    }
    expect(angles).toEqual([15.5, 16, 21, 20.5, 15.5, 60, 0])
    await handle.press('ArrowRight')
    await handle.press('Shift+ArrowRight')
    await expectTilted(lab, before)
    expect(await lab.time().getAttribute('aria-valuetext')).toBe('1.00 of 1.00 seconds')
  })
})

test.each([
  ['place', 'position', 'Place the block: start'],
  ['push', 'speed', 'Push the block: starting speed'],
])('the handle to %s the block changes its %s', async (id, parameter, name) => {
  const lab = await openLab()
  const before = (await lab.state()).parameters[parameter]!
  const selector = `[data-handle="${id}"]`
  await lab.page.locator(selector).scrollIntoViewIfNeeded()
  const { x, y } = await middle(lab.page, selector)
  await lab.page.mouse.move(x, y)
  await lab.page.mouse.down()
  await lab.page.mouse.move(x + 30, y - 8)
  await lab.page.mouse.up()
  const after = (await lab.state()).parameters[parameter]!
  expect(after).not.toBe(before)
  await lab.address(`${parameter}=${after}`)
  await lab.handle(name).press('ArrowRight')
  expect((await lab.state()).parameters[parameter]).toBeGreaterThan(after)
})

test.each(['fall', 'ramp', 'run-out', 'half-pipe', 'spring'])(
  'every handle of %s is at least 44 px wide and in the picture',
  async (scene) => {
    const { page } = await openLab(`scene=${scene}`, { width: 390 })
    const stage = (await page.locator('slide-stage').boundingBox())!
    const handles = await page.locator('.handle').all()
    expect(handles.length).toBeGreaterThan(1)
    for (const handle of handles) {
      const { x, y, width, height } = (await handle.boundingBox())!
      expect(Math.min(width, height)).toBeGreaterThanOrEqual(44)
      expect(x + width / 2).toBeGreaterThan(stage.x)
      expect(x + width / 2).toBeLessThan(stage.x + stage.width)
      expect(y + height / 2).toBeGreaterThan(stage.y)
      expect(y + height / 2).toBeLessThan(stage.y + stage.height)
    }
  },
)
