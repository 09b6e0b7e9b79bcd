import { describe, expect, test } from 'vitest'
import { focus, inOrder, tabTo, tour } from './keyboard.ts'
import { openLab, openLabOverText } from './labPage.ts'
import type { Lab } from './labPage.ts'

async function loadPlots({ page }: Lab): Promise<void> {
  await page.locator('slide-lab-plots').scrollIntoViewIfNeeded()
  await page.locator('slide-lab-plots canvas.chart').first().waitFor()
  await page.evaluate(() => scrollTo(0, 0))
}

/** Waits until the diagram is measured: until then there is a button to cancel it. */
async function measuresRest({ page }: Lab): Promise<void> {
  await page.locator('slide-lab-measures').scrollIntoViewIfNeeded()
  await page.locator('slide-speed-diagram summary').first().waitFor()
  await page.getByRole('button', { name: 'Cancel' }).waitFor({ state: 'detached' })
  await page.evaluate(() => scrollTo(0, 0))
}

describe('Tab', () => {
  test.each([1280, 390])(
    'at %d px leads to everything, in the order of the page',
    async (width) => {
      const lab = await openLabOverText('', { width })
      const { page } = lab
      await loadPlots(lab)
      await measuresRest(lab)
      const stops = await tour(page)
      expect(stops.filter(({ isSeen }) => !isSeen).map(({ name }) => name)).toEqual([])
      expect(inOrder(stops)).toEqual([
        ...['page-head', 'scenes', 'tools', 'modes', 'slide-stage', 'transport', 'forces'],
        ...[
          'parameters',
          'runners',
          'slide-lab-plots',
          'slide-lab-measures',
          'slide-step-inspector',
        ],
      ])
      // All that can be used is among them: of radio buttons one, and nothing of what is folded away.
      const usable = await page.evaluate(
        () =>
          [
            ...document.querySelectorAll<HTMLElement>(
              'slide-lab :is(button, input, select, summary, textarea, a[href], [tabindex="0"])',
            ),
          ].filter(
            (each) =>
              each.checkVisibility({ visibilityProperty: true }) &&
              !each.matches(':disabled, [type="radio"]:not(:checked)'),
          ).length,
      )
      expect(stops.filter(({ part }) => part !== 'page-head').length).toBe(usable)
      const names = stops.map(({ name }) => name)
      expect(names.filter((name) => !name)).toEqual([])
    },
  )

  test('with Shift goes the same way back', async () => {
    const { page } = await openLab()
    const there: string[] = []
    await page.getByRole('button', { name: 'No delta time' }).focus()
    for (let i = 0; i < 12; i++) {
      there.push((await focus(page)).name)
      await page.keyboard.press('Tab')
    }
    const back: string[] = []
    for (let i = 0; i < 12; i++) {
      await page.keyboard.press('Shift+Tab')
      back.unshift((await focus(page)).name)
    }
    expect(back).toEqual(there)
  })
})

test('the whole lab can be used with the keyboard alone', async () => {
  const lab = await openLab()
  const { page, state, now } = lab
  const press = (key: string) => page.keyboard.press(key)
  const pressed = async (...keys: string[]) => {
    for (const key of keys) await press(key)
    // A button that is off hands the focus on in the next frame.
    await expect
      .poll(async () => (await focus(page)).isBody, { message: `lost after ${keys.join(' ')}` })
      .toBe(false)
  }

  // A scene, and back to the ramp.
  await tabTo(page, 'Ramp')
  await pressed('ArrowRight')
  expect((await state()).scene).toBe('run-out')
  expect((await focus(page)).name).toBe('Run-out')
  await pressed('ArrowLeft')
  expect((await state()).scene).toBe('ramp')

  // What was done is undone and done again.
  await tabTo(page, 'Undo')
  await pressed('Enter')
  expect((await state()).scene).toBe('run-out')
  await tabTo(page, 'Redo')
  await pressed('Enter')
  expect((await state()).scene).toBe('ramp')
  // There is nothing left to do again, and the button hands the focus on.
  await expect.poll(async () => (await focus(page)).name).toBe('Undo')

  // A preset, its note, and what it says is closed.
  await tabTo(page, 'Presets')
  await pressed('ArrowDown')
  expect(await page.locator('.preset-note').innerText()).toContain('The fewer the frames')
  // The menu of sharing.
  await tabTo(page, 'Share')
  await pressed('Enter')
  await tabTo(page, 'Copy embed code: HTML')
  await press('Escape')
  expect((await focus(page)).name).toBe('Share')
  expect(await page.getByRole('button', { name: 'Copy link' }).isVisible()).toBe(false)

  // A mode of all runners.
  await tabTo(page, 'The paper')
  await pressed('Space')
  expect((await state()).runners.every(({ stopping }) => stopping === 'naive')).toBe(true)
  await tabTo(page, 'Clamped')
  await pressed('Enter')
  expect((await state()).runners.every(({ stopping }) => stopping === 'clamped')).toBe(true)
  await tabTo(page, 'Close the note')
  await press('Enter')
  expect(await page.locator('.preset-note').innerText()).toBe('')
  expect((await focus(page)).isBody).toBe(false)

  // The three handles: Tab goes through them one after the other.
  for (const [name, parameter, keys] of [
    [/^Place the block/, 'position', ['ArrowRight']],
    [/^Push the block/, 'speed', ['ArrowUp', 'ArrowUp']],
    [/^Tilt the track/, 'angle', ['PageUp', 'ArrowDown']],
  ] as const) {
    const before = (await state()).parameters[parameter]!
    await page.getByRole('button', { name: 'Clamped' }).focus()
    await tabTo(page, name)
    await pressed(...keys)
    expect((await state()).parameters[parameter]).toBeGreaterThan(before)
    expect((await focus(page)).name).toMatch(name)
  }

  // Time.
  await tabTo(page, 'To the start')
  await pressed('Enter')
  expect(await now()).toBe(0)
  await tabTo(page, 'One frame forward')
  await pressed('Enter', 'Enter')
  const stepped = await now()
  expect(stepped).toBeGreaterThan(0)
  await tabTo(page, 'Playback speed')
  await pressed('End')
  await tabTo(page, 'Play', 'Shift+Tab')
  await pressed('Space')
  expect((await focus(page)).name).toBe('Pause')
  await expect.poll(now).toBeGreaterThan(stepped)
  await pressed('Space')
  expect((await focus(page)).name).toBe('Play')
  await tabTo(page, 'Time')
  await pressed('End')
  expect(await now()).toBe((await state()).duration)

  // Forces.
  await tabTo(page, 'Show forces')
  await pressed('Space')
  expect(await page.locator('.forces table').isVisible()).toBe(true)

  // A parameter, slid and typed.
  await tabTo(page, 'Angle, slider')
  await pressed('Home', 'ArrowRight')
  expect((await state()).parameters.angle).toBe(0.5)
  await tabTo(page, /^Angle/)
  await page.keyboard.type('22.5')
  await pressed('Enter')
  expect((await state()).parameters.angle).toBe(22.5)
  await tabTo(page, 'Reset Angle')
  await press('Enter')
  expect((await state()).parameters.angle).toBe(15)
  // The button is gone; the focus is not.
  expect((await focus(page)).isBody).toBe(false)

  // A runner: rate, clock, integrator, stopping, timestep, with their options.
  await tabTo(page, 'Frame rate, 10 fps')
  await page.keyboard.type('12')
  await pressed('Tab')
  const first = async () => (await state()).runners[0]!
  expect((await first()).frames).toMatchObject({ fps: 12 })
  expect((await focus(page)).name).toBe('Frames, 12 fps')
  await pressed('ArrowDown')
  expect((await first()).frames.kind).toBe('jitter')
  await tabTo(page, /^Integrator, 12 fps/)
  await pressed('Home')
  expect((await first()).integrator).toBe('explicit-euler')
  await tabTo(page, /^Stopping, 12 fps/)
  await pressed('End')
  expect((await first()).stopping).toBe('located')
  await tabTo(page, /^Time step, 12 fps/)
  await pressed('End')
  expect((await first()).timestep.kind).toBe('tolerance')
  await pressed('ArrowUp')
  expect((await first()).timestep.kind).toBe('fixed')
  await tabTo(page, /^Most steps a frame/)
  expect((await focus(page)).isSeen).toBe(true)
  await page.keyboard.type('3')
  await pressed('Enter')
  expect((await first()).timestep).toMatchObject({ maxSteps: 3 })
  await tabTo(page, /^Hide 12 fps/)
  await pressed('Enter')
  expect((await first()).hidden).toBe(true)
  expect((await focus(page)).name).toMatch(/^Show 12 fps/)
  await tabTo(page, /^Duplicate/)
  await pressed('Enter')
  expect((await state()).runners.length).toBe(4)
  await tabTo(page, /^Remove/)
  await pressed('Enter')
  expect((await state()).runners.length).toBe(3)
  await tabTo(page, 'Add a runner')
  await pressed('Enter', 'Enter')
  expect((await state()).runners.length).toBe(5)
  // Where there is no room for more, the button is off and hands the focus on.
  await pressed('Enter', 'Enter', 'Enter')
  expect((await state()).runners.length).toBe(8)

  // A plot's table and the step inspector.
  await tabTo(page, /^As a table/)
  await pressed('Enter')
  await page.locator('slide-lab-plots table').first().waitFor()
  // Between the two are measures, which come as they are measured.
  await measuresRest(lab)
  await tabTo(page, 'Inside this step')
  await pressed('Enter')
  expect(await page.locator('slide-step-inspector details[open]').count()).toBe(1)

  // From anywhere in the lab.
  await press('Control+z')
  expect((await state()).runners.length).toBeLessThan(8)
  await press('Control+Shift+z')
  expect((await state()).runners.length).toBe(8)
  expect((await focus(page)).isBody).toBe(false)
  expect(lab.problems).toEqual([])
})

test('a recorded runner’s frame times are unfolded and changed by keys', async () => {
  const { page, state, runner } = await openLab('runners=recorded(durations:0.02+0.03)')
  expect(await runner(0).locator('.clock').innerText()).not.toContain('0.02')
  await page.getByRole('combobox', { name: 'Frames, Recorded' }).focus()
  await tabTo(page, '2 frames')
  await page.keyboard.press('Enter')
  await tabTo(page, /^Frame times/)
  await page.keyboard.press('Control+a')
  await page.keyboard.type('0.05')
  await page.keyboard.press('Tab')
  expect((await state()).runners[0]!.frames).toEqual({ kind: 'recorded', durations: [0.05] })
  await expect.poll(() => runner(0).locator('.times summary').innerText()).toBe('1 frame')
})

test('recording hands the focus from button to button', async () => {
  const { page } = await openLab()
  await page
    .locator('slide-record-frames')
    .evaluate((recorder) => ((recorder as unknown as { length: number }).length = 0.3))
  await page.getByRole('button', { name: 'Add a runner' }).focus()
  await tabTo(page, 'Record my frames')
  await page.keyboard.press('Enter')
  expect((await focus(page)).name).toBe('Cancel')
  await expect.poll(async () => (await focus(page)).name).toBe('Record again')
  await tabTo(page, 'Use for a new runner')
  for (let i = 0; i < 5; i++) {
    await page.keyboard.press('Enter')
    expect((await focus(page)).isBody).toBe(false)
  }
  expect(await page.locator('slide-runner-row').count()).toBe(8)
})

test('no limit of steps is said in words, and typed over', async () => {
  const { page, state } = await openLab('runners=30/fixed(step:1/60)')
  const field = page.getByRole('textbox', { name: 'Most steps a frame' })
  expect(await field.inputValue()).toBe('no limit')
  await field.focus()
  expect(await field.inputValue()).toBe('100000')
  await field.fill('2')
  await field.press('Tab')
  expect(await field.inputValue()).toBe('2')
  expect((await state()).runners[0]!.timestep).toMatchObject({ maxSteps: 2 })
})
