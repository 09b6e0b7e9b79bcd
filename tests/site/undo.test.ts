import { describe, expect, test } from 'vitest'
import { middle, openLab } from './labPage.ts'
import type { Lab } from './labPage.ts'

const undo = (lab: Lab) => lab.page.getByRole('button', { name: 'Undo' })
const redo = (lab: Lab) => lab.page.getByRole('button', { name: 'Redo' })
const angle = async (lab: Lab) => (await lab.state()).parameters.angle

test('there is nothing to undo at first; a change can be undone and done again', async () => {
  const lab = await openLab('angle=20')
  expect(await undo(lab).isDisabled()).toBe(true)
  expect(await redo(lab).isDisabled()).toBe(true)
  const before = await lab.pixels()
  await lab.slider('Angle').fill('40')
  expect(await redo(lab).isDisabled()).toBe(true)
  await undo(lab).click()
  expect(await angle(lab)).toBe(20)
  expect(await lab.pixels()).toEqual(before)
  expect(await undo(lab).isDisabled()).toBe(true)
  // The button that has nothing left to do gives the focus to the other.
  await expect.poll(() => lab.page.locator(':focus').getAttribute('aria-label')).toBe('Redo')
  await lab.address(/^#angle=20$/)
  await lab.page.keyboard.press('Enter')
  expect(await angle(lab)).toBe(40)
  await lab.address(/^#angle=40$/)
  expect(lab.problems).toEqual([])
})

test('a drag is one step, however long it is held still; the next one is another', async () => {
  const lab = await openLab()
  const { page } = lab
  const drag = async () => {
    const from = await middle(page, '[data-handle="tilt"]')
    await page.mouse.move(from.x, from.y)
    await page.mouse.down()
    await page.mouse.move(from.x, from.y - 20)
    // Longer than changes that are not held together may be apart.
    await page.waitForTimeout(1000)
    await page.mouse.move(from.x, from.y - 30, { steps: 5 })
    await page.mouse.up()
    return angle(lab)
  }
  const first = await drag()
  const second = await drag()
  expect(first).toBeGreaterThan(15)
  expect(second).toBeGreaterThan(first!)
  await undo(lab).click()
  expect(await angle(lab)).toBe(first)
  await undo(lab).click()
  expect(await angle(lab)).toBe(15)
  expect(await undo(lab).isDisabled()).toBe(true)
})

test('choices are steps of their own, however fast they follow each other', async () => {
  const lab = await openLab()
  const states = [await lab.state()]
  await lab.page.getByRole('button', { name: 'Add a runner' }).click()
  await lab.page.getByRole('button', { name: 'Add a runner' }).click()
  await lab.runner(0).getByLabel('Integrator, ').selectOption('rk4')
  await lab.page.getByRole('button', { name: 'Located' }).click()
  await lab.page.getByRole('radio', { name: 'Fall' }).check({ force: true })
  for (let i = 0; i < 5; i++) await undo(lab).click()
  expect(await lab.state()).toEqual(states[0])
  expect(await undo(lab).isDisabled()).toBe(true)
  for (let i = 0; i < 5; i++) await redo(lab).click()
  expect((await lab.state()).scene).toBe('fall')
})

describe('by key', () => {
  test.each([
    ['Control+z', 'Control+Shift+z'],
    ['Control+z', 'Control+y'],
    ['Meta+z', 'Meta+Shift+z'],
  ])('%s and %s', async (back, on) => {
    const lab = await openLab()
    await lab.slider('Angle').fill('40')
    await lab.page.keyboard.press(back)
    expect(await angle(lab)).toBe(15)
    await lab.page.keyboard.press(on)
    expect(await angle(lab)).toBe(40)
  })

  test('not while a number is being typed, whose own undo it is', async () => {
    const lab = await openLab()
    await lab.slider('Angle').fill('40')
    await lab.field('Mass').focus()
    await lab.page.keyboard.type('7')
    await lab.page.keyboard.press('Control+z')
    expect(await angle(lab)).toBe(40)
    await lab.field('Mass').fill('3')
    await lab.field('Mass').press('Enter')
    await lab.field('Mass').press('Control+z')
    expect((await lab.state()).parameters.mass).toBe(1)
    expect(await lab.field('Mass').inputValue()).toBe('1')
  })

  test('only while the lab has the focus', async () => {
    const lab = await openLab()
    await lab.slider('Angle').fill('40')
    await lab.page.getByRole('button', { name: 'Theme' }).focus()
    await lab.page.keyboard.press('Control+z')
    expect(await angle(lab)).toBe(40)
  })
})

test('removed runners come back, and what is selected is always there', async () => {
  const lab = await openLab()
  const { page } = lab
  const selected = () =>
    page.evaluate(() => {
      const rows = [...document.querySelectorAll('slide-runner-row')]
      return rows.map((row) => row.hasAttribute('selected'))
    })
  await page.getByRole('button', { name: 'Remove 10 fps' }).click()
  await expect.poll(selected).toEqual([true, false])
  await page.getByRole('button', { name: 'Remove 120 fps' }).click()
  await expect.poll(selected).toEqual([true])
  await page.keyboard.press('Control+z')
  await page.keyboard.press('Control+z')
  await expect.poll(async () => (await selected()).length).toBe(3)
  expect(lab.problems).toEqual([])
})

test('opening an address is a step as well', async () => {
  const lab = await openLab()
  await lab.slider('Angle').fill('40')
  await lab.goTo('#scene=fall')
  await expect.poll(async () => (await lab.state()).scene).toBe('fall')
  await undo(lab).click()
  expect(await angle(lab)).toBe(40)
  await lab.address(/^#angle=40$/)
  await undo(lab).click()
  expect(await angle(lab)).toBe(15)
})
