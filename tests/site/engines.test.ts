import { expect, test } from 'vitest'
import { engines } from '../../src/engines/index.ts'
import { openLab } from './labPage.ts'

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
  await lab.address(/fixed\(step:1\/60,maxSteps:8,draw:latest\)/)

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
