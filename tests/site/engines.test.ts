import { expect, test } from 'vitest'
import { engines } from '../../src/engines/index.ts'
import { openLab } from './labPage.ts'
import { openPage } from './page.ts'

test('the menu of engines sets the runners, says what was left out, and is undone', async () => {
  const lab = await openLab('runners=45;144')
  const { page, problems } = lab
  const menu = page.getByRole('combobox', { name: 'Your engine', exact: true })
  const note = page.locator('.preset-note')
  await expect.poll(() => menu.locator('option').count()).toBe(engines.length + 2)
  const before = await lab.state()

  await menu.selectOption({ label: 'Godot 4' })
  const { runners } = await lab.state()
  expect(runners.map(({ frames }) => frames)).toEqual(before.runners.map(({ frames }) => frames))
  for (const { timestep } of runners)
    expect(timestep).toMatchObject({ kind: 'fixed', step: 1 / 60, maxSteps: 8, draw: 'latest' })
  expect(await note.innerText()).toContain('Left out: the jitter fix')
  await lab.address(/runners=45\/godot;144\/godot$/)

  await menu.selectOption({ label: 'Compare engines' })
  expect((await lab.state()).runners.map(({ frames }) => frames)).toEqual(
    Array.from({ length: 6 }, () => before.runners[0]!.frames),
  )
  expect(await menu.locator('option:checked').innerText()).toBe('Compare engines')
  await page.locator('.tools .step').first().click()
  await page.locator('.tools .step').first().click()
  expect(await lab.state()).toEqual(before)
  expect(await menu.locator('option:checked').innerText()).toBe('Your engine')
  expect(problems).toEqual([])
})

test('an engine whose run would be too long changes nothing, says so, and the menu names none', async () => {
  const lab = await openLab('duration=100000&runners=1')
  const { page, problems } = lab
  const menu = page.getByRole('combobox', { name: 'Your engine', exact: true })
  await expect.poll(() => menu.locator('option').count()).toBe(engines.length + 2)
  const before = await lab.state()
  await menu.selectOption({ label: 'Source, player' })
  const alert = page.getByRole('alert')
  await alert.waitFor()
  expect(await alert.innerText()).toMatch(
    /^“Source, player” can’t be run here. The lab stays as it is.\s.* asks for /s,
  )
  expect(await lab.state()).toEqual(before)
  expect(await menu.locator('option:checked').innerText()).toBe('Your engine')
  // It goes with the next thing that can be done.
  await menu.selectOption({ label: 'Quake' })
  await expect.poll(() => alert.count()).toBe(0)
  expect(await menu.locator('option:checked').innerText()).toBe('Quake')
  expect(problems).toEqual([])
})

test('a runner’s own menu makes it an engine’s, in its link too, until its method is changed', async () => {
  const { page, address, state, problems } = await openLab('runners=45;45')
  const row = page.locator('slide-runner-row').nth(1)
  const menu = row.getByRole('combobox', { name: /^Engine, / })
  await menu.focus()
  await page.keyboard.type('Godot')
  await address(/runners=45;45\/godot$/)
  expect((await state()).runners.map(({ engine }) => engine)).toEqual([undefined, 'Godot 4'])
  // The menu keeps the focus, and the note says what it does.
  expect(await menu.evaluate((element) => element === document.activeElement)).toBe(true)
  expect(await page.locator('.runners .notes').innerText()).toContain('Left out: the jitter fix')
  expect(await row.locator('.runner').getAttribute('aria-label')).toBe('Godot 4')
  await row.getByRole('combobox', { name: /^Stopping, / }).selectOption('located')
  await address(/runners=45;45\/fixed\(.*\)\/semi-implicit-euler$/)
  expect(await menu.locator('option:checked').innerText()).toBe('none')
  expect(await page.locator('.runners .notes').innerText()).not.toContain('Left out')
  expect(problems).toEqual([])
})

test('the figure moves the kick as the chosen engine does, and says what to change in it', async () => {
  const { page, problems } = await openPage()
  const figure = page.locator('#figure-your-engine slide-figure')
  await figure.scrollIntoViewIfNeeded()
  await figure.getByLabel('Engine').selectOption({ label: 'Godot 4' })
  await figure.getByText('hitches of 0.4 s').click()
  const says = figure.locator('[part="outcome"]')
  await expect.poll(() => says.innerText()).toContain('in one place. The slowest game loses 0.53')
  expect(await figure.innerText()).toContain('set Physics Ticks per Second to 120')
  await figure.getByText('on the safe side', { exact: true }).click()
  await expect.poll(() => says.innerText()).toMatch(/in one place\.$/)
  expect(problems).toEqual([])
})
