import { describe, expect, test } from 'vitest'
import { frameClocks, integrators, scenes, stoppings, timesteps } from '../../src/physics/index.ts'
import type { Options } from '../../src/physics/index.ts'
import { modes } from '../../src/lab/state/modes.ts'
import { openingOf } from '../../src/lab/state/opening.ts'
import { openLab } from './labPage.ts'
import type { Picture } from './picture.ts'

describe('a runner', () => {
  test('takes every entry of its menus', async () => {
    const { page, state, runner, problems } = await openLab()
    for (const [label, list, key] of [
      ['Integrator', integrators, 'integrator'],
      ['Stopping', stoppings, 'stopping'],
      ['Time step', timesteps, 'timestep'],
      ['Frames', frameClocks, 'frames'],
    ] as const) {
      const menu = runner(1).getByLabel(`${label}, `).first()
      expect(await menu.locator('option').allInnerTexts()).toEqual(list.map((entry) => entry.label))
      for (const { id, about } of list) {
        await menu.selectOption(id)
        const chosen = (await state()).runners[1]![key]
        expect(typeof chosen === 'string' ? chosen : chosen.kind).toBe(id)
        expect(await menu.getAttribute('title')).toBe(about)
        expect(await page.locator('.notes').innerText()).toContain(about)
      }
    }
    expect((await state()).runners[0]).toEqual(openingOf('ramp').runners[0])
    expect(problems).toEqual([])
  })

  test('has a field for every option of its time step and its frames', async () => {
    const { state, runner } = await openLab()
    const all = [
      ...timesteps.map(({ id, options }) => ['Time step', 'timestep', id, options] as const),
      ...frameClocks.map(({ id, options }) => ['Frames', 'frames', id, options] as const),
    ].flatMap(([label, key, id, options]) =>
      Object.entries(options as Options).map(([name, option]) => {
        return { label, key, id, name, option }
      }),
    )
    for (const { label, key, id, name, option } of all) {
      await runner(0).getByLabel(`${label}, `).selectOption(id)
      const its = { name: new RegExp(`^${option.label}( \\[s\\])?, `) }
      if (option.type === 'choice') {
        for (const choice of option.choices) {
          await runner(0).getByRole('combobox', its).selectOption(choice)
          expect((await state()).runners[0]![key]).toMatchObject({ [name]: choice })
        }
      } else {
        const [typed, value] =
          option.type === 'list'
            ? ['1/60, 0.02 0.05', [1 / 60, 0.02, 0.05]]
            : name === 'fps' || option.integer
              ? ['20', 20]
              : option.type === 'number' && option.max < 0.5
                ? ['1e-5', 1e-5]
                : ['0.5', 0.5]
        if (option.type === 'list') await runner(0).locator('.times summary').click()
        await runner(0).getByRole('textbox', its).fill(typed)
        await runner(0).getByRole('textbox', its).press('Enter')
        expect((await state()).runners[0]![key]).toMatchObject({ [name]: value })
      }
    }
  })

  test('takes a frame rate, and refuses one that can’t be', async () => {
    const { state, runner, spread, page } = await openLab()
    const rate = runner(0).getByRole('textbox', { name: 'Frame rate' })
    await rate.fill('60')
    await rate.press('Enter')
    expect((await state()).runners[0]!.frames).toEqual({ kind: 'steady', fps: 60 })
    const before = await spread()
    await rate.fill('0')
    await rate.press('Enter')
    expect(await runner(0).getByRole('alert').innerText()).toBe('0 is not in 1…10000')
    expect(await rate.getAttribute('aria-invalid')).toBe('true')
    expect(await spread()).toBe(before)
    await rate.press('ArrowUp')
    expect((await state()).runners[0]!.frames).toEqual({ kind: 'steady', fps: 61 })
    expect(await page.getByRole('alert').count()).toBe(0)
  })

  test('can be hidden, duplicated, removed and added, up to eight and down to one', async () => {
    const { state, runner, page, spread } = await openLab()
    const rows = page.locator('slide-runner-row')
    await page.getByRole('button', { name: 'Hide 10 fps' }).click()
    expect(await spread()).toBe('0.06\u202fm')
    await page.getByRole('button', { name: 'Show 10 fps' }).click()
    expect(await spread()).toBe('0.23\u202fm')
    await page.getByRole('button', { name: 'Duplicate 30 fps' }).click()
    expect((await state()).runners[2]).toEqual({ ...(await state()).runners[1], paletteIndex: 3 })
    await page.getByRole('button', { name: 'Remove 10 fps' }).click()
    expect(await rows.count()).toBe(3)
    const add = page.getByRole('button', { name: 'Add a runner' })
    while (await add.isEnabled()) await add.click()
    expect(await rows.count()).toBe(8)
    expect(await page.getByRole('button', { name: 'Duplicate' }).first().isDisabled()).toBe(true)
    for (let i = 0; i < 7; i++) await runner(0).getByRole('button', { name: 'Remove' }).click()
    expect(await rows.count()).toBe(1)
    expect(await runner(0).getByRole('button', { name: 'Remove' }).isDisabled()).toBe(true)
  })

  test('refuses frame times that are none, and says why', async () => {
    const { state, runner, page } = await openLab('runners=recorded(durations:0.02)')
    await runner(0).getByText('1 frame').click()
    await runner(0).getByRole('textbox', { name: 'Frame times' }).fill('0.02 soon')
    await page.keyboard.press('Enter')
    expect(await runner(0).getByRole('alert').innerText()).toBe('"soon" is not a number')
    expect((await state()).runners[0]!.frames).toEqual({ kind: 'recorded', durations: [0.02] })
    await runner(0).getByRole('textbox', { name: 'Frame times' }).fill('0.03')
    await page.keyboard.press('Enter')
    expect(await page.getByRole('alert').count()).toBe(0)
  })

  test('that is removed leaves the focus among the others', async () => {
    const { page } = await openLab()
    await page.getByRole('button', { name: 'Remove 30 fps' }).click()
    const label = await page.evaluate(() => document.activeElement?.getAttribute('aria-label'))
    expect(label).toBe('Hide 120 fps')
  })

  test('that can’t be run so says why, and stays as it was', async () => {
    const { state, runner, field, page } = await openLab()
    await field('Duration').fill('1000')
    await field('Duration').press('Enter')
    await runner(0).getByLabel('Time step, ').selectOption('substeps')
    const step = runner(0).getByRole('textbox', { name: /^Step/ })
    await step.fill('1e-5')
    await step.press('Enter')
    expect(await page.getByRole('alert').innerText()).toContain('steps, more than')
    expect((await state()).runners[0]!.timestep).toMatchObject({ kind: 'substeps', step: 1 / 60 })
  })
})

describe('a parameter', () => {
  test('can be slid, typed, pasted, stepped and reset', async () => {
    const { state, field, slider, page, spread } = await openLab()
    const angle = async () => (await state()).parameters.angle
    const before = await spread()
    await slider('Angle').fill('30')
    expect(await angle()).toBe(30)
    expect(await spread()).not.toBe(before)
    expect(await slider('Angle').getAttribute('aria-valuetext')).toBe('30 °')
    await slider('Angle').press('ArrowRight')
    expect(await angle()).toBe(30.5)
    for (const [typed, value] of [
      ['1e-3', 0.001],
      ['75', 75],
      ['1/3', 1 / 3],
    ] as const) {
      await field('Angle').fill(typed)
      await field('Angle').press('Tab')
      expect(await angle()).toBe(value)
    }
    await field('Angle').focus()
    await page.evaluate(() => document.execCommand('insertText', false, '12.25'))
    await page.keyboard.press('Enter')
    expect(await angle()).toBe(12.25)
    await field('Angle').press('ArrowUp')
    await field('Angle').press('Shift+ArrowDown')
    expect(await angle()).toBe(7.75)
    await page.getByRole('button', { name: 'Reset Angle' }).click()
    expect(await angle()).toBe(15)
    expect(await page.getByRole('button', { name: 'Reset Angle' }).count()).toBe(0)
    expect(await spread()).toBe(before)
  })

  test.each([
    ['95', '95 is not in 0…90'],
    ['steep', '"steep" is not a number'],
  ])('refuses %s, says why, and leaves everything as it was', async (typed, message) => {
    const { state, field, page, pixels } = await openLab()
    await field('Angle').focus()
    await page.locator('.sheet').press('Shift')
    const before = await pixels()
    await field('Angle').fill(typed)
    await field('Angle').press('Enter')
    expect(await page.getByRole('alert').innerText()).toContain(message)
    expect(await field('Angle').inputValue()).toBe(typed)
    expect((await state()).parameters.angle).toBe(15)
    expect(await pixels()).toEqual(before)
    await field('Angle').press('Escape')
    expect(await page.getByRole('alert').count()).toBe(0)
    expect(await field('Angle').inputValue()).toBe('15')
  })

  test('of friction takes the other along', async () => {
    const { slider, field } = await openLab()
    await slider('Kinetic friction').fill('0.9')
    expect(await field('Static friction').inputValue()).toBe('0.9')
    await slider('Static friction').fill('0.3')
    expect(await field('Kinetic friction').inputValue()).toBe('0.3')
  })

  test('that does not go with the others is refused in its place', async () => {
    const { slider, page, state } = await openLab('scene=half-pipe')
    await slider('Radius').fill('1')
    expect(await page.getByRole('alert').innerText()).toContain('Start: 2.8 is not inside the pipe')
    expect((await state()).parameters.radius).toBe(2)
    expect(await slider('Radius').inputValue()).toBe('2')
  })

  test('of time: the run gets longer and the cursor stays at its end', async () => {
    const { page, slider, state, time } = await openLab()
    await slider('Duration').fill('3')
    expect((await state()).duration).toBe(3)
    expect(await time().getAttribute('aria-valuetext')).toBe('3.00 of 3.00 seconds')
    expect(await time().inputValue()).toBe('3')
    await slider('Duration').fill('2')
    expect(await time().inputValue()).toBe('2')
    await slider('Duration').fill('5')
    expect(await time().inputValue()).toBe('5')
    // One that is not at the end stays where it is, and what is too short takes it along.
    await time().fill('2.5')
    await slider('Duration').fill('4')
    expect(await time().inputValue()).toBe('2.5')
    await slider('Duration').fill('2')
    expect(await time().inputValue()).toBe('2')
    // What was done so fast is one step back.
    await page.getByRole('button', { name: 'Undo' }).click()
    await expect.poll(() => time().getAttribute('aria-valuetext')).toBe('1.00 of 1.00 seconds')
    expect(await time().inputValue()).toBe('1')
  })
})

test('every scene opens with its own parameters', async () => {
  const { page, state, problems, pixels } = await openLab()
  const pictures: Picture[] = []
  for (const { id, label, parameters } of scenes) {
    await page.getByRole('radio', { name: label }).check({ force: true })
    expect(await state()).toEqual({ ...openingOf(id), runners: openingOf('ramp').runners })
    const labels = await page.locator('.parameters .quantity-label').allInnerTexts()
    const shared = ['Duration', 'Time scale']
    const expected = [...Object.values(parameters).map((each) => each.label), ...shared]
    expect(labels.length).toBe(expected.length)
    expected.forEach((text, i) => expect(labels[i]).toContain(text))
    const picture = await pixels()
    for (const other of pictures) expect(picture).not.toEqual(other)
    pictures.push(picture)
  }
  expect(problems).toEqual([])
})

test('the buttons set all runners at once', async () => {
  const { page, state, spread } = await openLab()
  const spreads: string[] = []
  for (const { label, method, about } of modes) {
    await page.getByRole('button', { name: label }).click()
    for (const runner of (await state()).runners) expect(runner).toMatchObject(method)
    expect(
      await page.locator('slide-lab').getByRole('button', { pressed: true }).allInnerTexts(),
    ).toEqual([label])
    expect(await page.locator('.modes .about').innerText()).toBe(about)
    spreads.push((await spread()).replaceAll('\u202f', ' '))
  }
  expect(spreads.slice(0, 3)).toEqual(['0.95 m', '0.31 m', '0.23 m'])
  expect(spreads[3]).toMatch(/^0( |$)/)
  expect(spreads[4]).toBe('0 (to rounding)')
  await page.locator('slide-runner-row').first().getByLabel('Integrator').selectOption('rk8')
  expect(await page.locator('slide-lab').getByRole('button', { pressed: true }).count()).toBe(0)
})
