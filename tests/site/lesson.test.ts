import { expect, inject, test } from 'vitest'
import { figure, openHost } from './hostPage.ts'
import { openLab } from './labPage.ts'
import { openPage } from './page.ts'

/* What a lab, a figure and a frame leave to readers in a lesson. */

test('a link for a lesson is made by ticking, and leaves just that', async () => {
  const lab = await openLab('angle=20', { width: 1280 })
  await lab.page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
  await lab.page.getByRole('button', { name: 'Share' }).click()
  await lab.page.getByText('For a lesson').click()
  for (const name of ['Angle', 'Frame rate', 'The exact block and errors'])
    await lab.page.getByRole('checkbox', { name }).check()
  await lab.page.getByRole('button', { name: 'Copy link for the lesson' }).click()
  await expect
    .poll(() => lab.page.evaluate(() => navigator.clipboard.readText()))
    .toBe(`${inject('address')}lab.html#angle=20&controls=angle,fps&hide=exact`)

  const lesson = await openLab('angle=20&controls=angle,fps&hide=exact', { width: 1280 })
  const { page } = lesson
  expect(await page.locator('slide-lab').getByRole('combobox').count()).toBe(1)
  expect(
    await page
      .locator('slide-lab')
      .getByRole('slider')
      .evaluateAll((all) => all.map((each) => each.ariaLabel)),
  ).toEqual(['Tilt the track: angle', 'Time', 'Angle, slider'])
  expect(await page.locator('.tools button').count()).toBe(2)
  for (const gone of ['.modes', '.scenes', 'slide-lab-measures', 'slide-step-inspector', '.add'])
    expect(await page.locator(`slide-lab ${gone}`).count(), gone).toBe(0)
  // Nothing tells of the exact block: no words, no curve, no error.
  await expect.poll(() => page.locator('slide-lab').innerText()).not.toMatch(/exact\b(?!ly)/)
  expect(await page.locator('slide-stage canvas').getAttribute('aria-label')).not.toMatch(/exact/)
  expect(await page.locator('.runner .end output').allInnerTexts()).toEqual(['–', '–', '–'])
  // What may be used works, and the address keeps the lesson.
  await lesson.slider('Angle').fill('25')
  await lesson.address(/^#angle=25&controls=angle,fps&hide=exact$/)
  await page.reload()
  await page.locator('slide-lab .parameters').waitFor()
  expect(await lesson.slider('Mass').count()).toBe(0)
  const refused = await page.evaluate(() =>
    (
      document.querySelector('slide-lab') as unknown as { change: (change: object) => string }
    ).change({
      kind: 'duration',
      duration: 3,
    }),
  )
  expect(refused).toMatch(/lesson/)
  expect(lesson.problems).toEqual([])
})

test('a name that there is not is told of', async () => {
  const { page } = await openLab('controls=angel&hide=spread')
  expect(await page.locator('.refusal').innerText()).toMatch(/controls: there is no “angel”/)
})

test('a frame that is locked has playing and the time', async () => {
  const { page } = await openPage({ path: '404.html' })
  await page.goto(new URL('embed.html#locked=1', inject('address')).href)
  await page.getByRole('button', { name: 'Play' }).waitFor()
  await page.locator('slide-frame-strip canvas').first().waitFor()
  const names = await page
    .locator('button, select, input, a, [role="slider"]')
    .evaluateAll((all) => all.map((each) => each.ariaLabel))
  expect(names).toEqual([
    'To the start',
    'One frame back',
    'Play',
    'One frame forward',
    'To the end',
    'Playback speed',
    'Time',
  ])
})

test('elements are limited by attributes, and tell of wrong names', async () => {
  const { page } = await openHost(
    `<slide-lab compact controls="angle" hide="spread"></slide-lab>
    ${figure.replace('>', ' controls="steps" hide="readings outcome">')}
    <slide-figure name="falling-ball" locked></slide-figure>`,
  )
  const lab = page.locator('slide-lab')
  await lab.locator('slide-stage canvas').waitFor()
  expect(await lab.getByRole('slider').evaluateAll((all) => all.map((e) => e.ariaLabel))).toEqual([
    'Tilt the track: angle',
    'Time',
  ])
  expect(await lab.locator('.spread').count()).toBe(0)
  const wrong = page.locator('slide-figure').first()
  await expect
    .poll(() => wrong.getByRole('alert').innerText())
    .toMatch(/no “steps”; there are: .*step/)
  await wrong.evaluate((element) => element.setAttribute('controls', 'step'))
  await expect.poll(() => wrong.getByRole('alert').count()).toBe(0)
  expect(await wrong.locator('.controls .slider').count()).toBe(1)
  expect(await wrong.locator('.says, .readings').count()).toBe(0)
  const locked = page.locator('slide-figure').last()
  await locked.scrollIntoViewIfNeeded()
  await locked.locator('.play').waitFor()
  expect(await locked.locator('.controls, .grip').count()).toBe(0)
})
