import { expect, test } from 'vitest'
import { opening } from '../../src/lab/state/opening.ts'
import { presets } from '../../src/lab/presets/index.ts'
import { isLong, some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openLab } from './labPage.ts'
import type { Lab } from './labPage.ts'

const menu = (lab: Lab) => lab.page.getByRole('combobox', { name: 'Presets', exact: true })
const chosen = (lab: Lab) => menu(lab).locator('option:checked').innerText()
const note = (lab: Lab) => lab.page.locator('.preset-note')
const choose = (lab: Lab, label: string) => menu(lab).selectOption({ label })
const named = (text: string) => presets.find(({ label }) => label.startsWith(text))!

test('every preset can be chosen, is drawn without a problem, and says what to watch', async () => {
  const lab = await openLab()
  const labels = await menu(lab).locator('option').allInnerTexts()
  expect(labels).toEqual(['Presets', ...presets.map(({ label }) => label)])
  // All of them are known to run; what can differ here is how they are chosen and drawn.
  for (const { label, watch, shown } of isLong ? presets : presets.filter((_, i) => i % 3 === 0)) {
    await choose(lab, label)
    expect(await note(lab).innerText()).toContain(`${label}. ${watch}`)
    expect(await lab.state(), label).toEqual(shown.state)
    expect(await lab.page.getByRole('alert').count(), label).toBe(shown.problem ? 1 : 0)
    expect(lab.problems, label).toEqual([])
  }
})

test('Back and Forward go from preset to preset, drags stay in one entry', async () => {
  const lab = await openLab()
  const { page } = lab
  const [pipe, wall] = [named('Stops on the flat'), named('Stops uphill and comes')]
  await choose(lab, pipe.label)
  await lab.slider('Gravity').fill('5')
  await lab.slider('Gravity').fill('6')
  await lab.address(/gravity=6/)
  const dragged = await lab.state()
  await choose(lab, wall.label)
  await page.goBack()
  await expect.poll(() => lab.state()).toEqual(dragged)
  await page.goBack()
  await expect.poll(() => lab.state()).toEqual(opening)
  await lab.address(/^$/)
  await page.goForward()
  await expect.poll(() => lab.state()).toEqual(dragged)
  await page.goForward()
  await expect.poll(() => lab.state()).toEqual(wall.shown.state)
  await page.reload()
  await expect.poll(lab.state).toEqual(wall.shown.state)
  expect(lab.problems).toEqual([])
})

test('the menu names the preset as long as nothing of it is changed, and it can be undone', async () => {
  const lab = await openLab('angle=20')
  const before = await lab.state()
  const { label } = named('Jitter')
  expect(await chosen(lab)).toBe('Presets')
  await choose(lab, label)
  expect(await chosen(lab)).toBe(label)
  await lab.slider('Gravity').fill('5')
  expect(await chosen(lab)).toBe('Presets')
  // The note stays, so that nothing jumps.
  expect(await note(lab).innerText()).toContain(label)
  await lab.page.keyboard.press('Control+z')
  expect(await chosen(lab)).toBe(label)
  await lab.page.keyboard.press('Control+z')
  expect(await lab.state()).toEqual(before)
  expect(await note(lab).innerText()).toBe('')
  expect(await chosen(lab)).toBe('Presets')
  await lab.page.getByRole('button', { name: 'Redo' }).click()
  expect(await note(lab).innerText()).toContain(label)
})

test('the note can be closed, and goes with the scene', async () => {
  const lab = await openLab()
  await choose(lab, named('Jitter').label)
  await lab.page.getByRole('button', { name: 'Close the note' }).click()
  expect(await note(lab).innerText()).toBe('')
  await choose(lab, named('A hitch').label)
  await lab.page.getByRole('radio', { name: 'Fall' }).check({ force: true })
  expect(await note(lab).innerText()).toBe('')
})

test('what can’t be run says why, and undo brings back what was there', async () => {
  const lab = await openLab('angle=20')
  await choose(lab, named('No mass').label)
  expect(await lab.page.getByRole('alert').innerText()).toContain('parameters.mass')
  await lab.page.getByRole('button', { name: 'Undo' }).click()
  expect(await lab.page.getByRole('alert').count()).toBe(0)
  expect((await lab.state()).parameters.angle).toBe(20)
})

test.each(
  some(
    [
      [320, 'light'],
      [390, 'dark'],
      [768, 'light'],
      [1440, 'dark'],
    ] as const,
    ...[0, 3],
  ),
)('%d px wide, %s: no sideways scroll, and axe finds nothing', async (width, scheme) => {
  const lab = await openLab('', { width, colorScheme: scheme, hasTouch: width < 800 })
  await choose(lab, named('Steep enough').label)
  await lab.page.getByRole('button', { name: 'Share' }).click()
  expect(await lab.page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
  expect(await violationsOn(lab.page)).toEqual([])
})
