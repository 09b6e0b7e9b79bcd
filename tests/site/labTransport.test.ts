import { expect, test } from 'vitest'
import { outOfSight } from './frames.ts'
import { openLab } from './labPage.ts'

test('play goes from the start to the end and stops there, pause holds', async () => {
  const lab = await openLab()
  const { now } = lab
  const { page } = lab
  await page.getByRole('button', { name: 'Play', exact: true }).click()
  await expect.poll(now).toBeLessThan(0.9)
  await expect.poll(now).toBeGreaterThan(0.05)
  await page.getByRole('button', { name: 'Pause' }).click()
  const held = await now()
  const pixels = await lab.pixels()
  expect(held).toBeLessThan(1)
  await page.waitForTimeout(150)
  expect(await now()).toBe(held)
  expect(await lab.pixels()).toEqual(pixels)
  await page.getByRole('button', { name: 'Play', exact: true }).click()
  await expect.poll(now, { timeout: 5000 }).toBe(1)
  await expect.poll(() => page.getByRole('button', { name: 'Pause' }).count()).toBe(0)
  expect(lab.problems).toEqual([])
})

test('a slower speed takes longer', async () => {
  const lab = await openLab()
  const { now } = lab
  await lab.page.getByLabel('Playback speed').selectOption('¹⁄₁₆×')
  await lab.page.getByRole('button', { name: 'Play', exact: true }).click()
  await expect.poll(now).toBeGreaterThan(0.01)
  expect(await now()).toBeLessThan(0.5)
})

test('steps go to the next and the previous frame of any visible runner', async () => {
  const lab = await openLab()
  const { page } = lab
  const { now } = lab
  const press = (name: string) => page.getByRole('button', { name, exact: true }).click()
  await press('To the start')
  expect(await now()).toBe(0)
  const times: number[] = []
  for (let i = 0; i < 5; i++) {
    await press('One frame forward')
    times.push(await now())
  }
  expect(times).toEqual([1, 2, 3, 4, 5].map((n) => n / 120))
  await press('One frame back')
  expect(await now()).toBe(4 / 120)
  await page.getByRole('button', { name: 'Hide 120 fps' }).click()
  await press('One frame forward')
  expect(await now()).toBe(2 / 30)
  await press('One frame forward')
  expect(await now()).toBe(0.1)
  await press('To the end')
  expect(await now()).toBe(1)
  await press('One frame back')
  expect(await now()).toBe(29 / 30)
})

test('the keys do the same while the lab has the focus', async () => {
  const lab = await openLab()
  const { page } = lab
  const { now } = lab
  await page.keyboard.press('Home')
  expect(await now()).toBe(1)
  await page.getByRole('button', { name: 'Clamped' }).focus()
  await page.keyboard.press('Home')
  expect(await now()).toBe(0)
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('Shift+ArrowRight')
  expect(await now()).toBe(11 / 120)
  await page.keyboard.press('ArrowLeft')
  expect(await now()).toBe(10 / 120)
  await page.keyboard.press('Shift+ArrowLeft')
  expect(await now()).toBe(0)
  await page.keyboard.press('End')
  expect(await now()).toBe(1)
  await lab.page.locator('slide-stage').click({ position: { x: 5, y: 5 } })
  await page.keyboard.press('Space')
  await expect.poll(() => page.getByRole('button', { name: 'Pause' }).count()).toBe(1)
  await page.keyboard.press('Space')
  expect(await page.getByRole('button', { name: 'Pause' }).count()).toBe(0)
})

test('the keys belong to a field or slider that has the focus', async () => {
  const lab = await openLab()
  const { now } = lab
  await lab.field('Angle').press('Home')
  await lab.field('Angle').press('ArrowLeft')
  await lab.slider('Angle').press('Home')
  expect(await now()).toBe(1)
  expect((await lab.state()).parameters.angle).toBe(0)
})

test('the time slider goes to any instant, and errors and words follow', async () => {
  const lab = await openLab()
  await lab.time().fill('0.5')
  expect(await lab.page.locator('.transport .clock').innerText()).toBe('0.50 / 1.00 s')
  expect(await lab.runner(0).locator('.now output').innerText()).toBe('−0.182\u202fm')
  expect(await lab.runner(0).locator('.end output').innerText()).toBe('−0.246\u202fm')
  await expect
    .poll(() => lab.page.locator('slide-lab [aria-live]').textContent())
    .toContain('Ramp after 0.50')
})

test('while it plays nothing is told, and off the screen nothing runs', async () => {
  const lab = await openLab('duration=20', { height: 500 })
  const { page } = lab
  const { now } = lab
  const words = () => page.locator('slide-lab [aria-live]').textContent()
  // Words follow the picture a little later.
  await expect.poll(words).toContain('Ramp after 20.00')
  const before = await words()
  await page.getByRole('button', { name: 'Play', exact: true }).click()
  await page.waitForTimeout(900)
  expect(await words()).toBe(before)
  await page.evaluate(() => {
    const space = document.createElement('div')
    space.style.height = '5000px'
    document.body.append(space)
    scrollTo(0, 1e6)
  })
  await outOfSight(page.locator('slide-lab'))
  const away = await now()
  await page.waitForTimeout(300)
  expect(await now()).toBe(away)
  await page.evaluate(() => scrollTo(0, 0))
  await expect.poll(now).toBeGreaterThan(away)
})

test('every frame has its tick in the strip', async () => {
  const { page } = await openLab()
  const ticks = await page.evaluate(() => {
    const canvas = document.querySelector<HTMLCanvasElement>('slide-frame-strip canvas')!
    const { width, height } = canvas
    const { data } = canvas.getContext('2d')!.getImageData(0, 0, width, height)
    const row = height / 3
    return [0, 1, 2].map((i) => {
      // Near the top of the tick, where the line through the middle is not.
      const y = Math.round(i * row + row / 2 - 2)
      let count = 0
      for (let x = 0, before = false; x < width; x++) {
        const filled = data[4 * (y * width + x) + 3]! > 0
        if (filled && !before) count++
        before = filled
      }
      return count
    })
  })
  expect(ticks).toEqual([11, 31, 121])
})
