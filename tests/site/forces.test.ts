import { expect, test } from 'vitest'
import { forcesAt, parseExperiment, simulate } from '../../src/physics/index.ts'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openLab } from './labPage.ts'
import type { Picture } from './picture.ts'

const experiment = parseExperiment({
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  integrator: 'semi-implicit-euler',
  stopping: 'clamped',
  frames: { kind: 'steady', fps: 30 },
  duration: 1,
})

async function openForces(...given: Parameters<typeof openLab>) {
  const lab = await openLab(...given)
  const { page } = lab
  await page.getByRole('checkbox', { name: 'Show forces' }).check()
  const figures = (name: string) =>
    page.locator('.forces').getByRole('row', { name }).getByRole('cell').allInnerTexts()
  return { ...lab, figures, line: () => page.locator('.friction-line').innerText() }
}

test('at first there are no arrows; the switch shows them and hides them again', async () => {
  const { page, pixels, problems } = await openLab()
  const box = page.getByRole('checkbox', { name: 'Show forces' })
  expect(await box.isChecked()).toBe(false)
  expect(await page.locator('.forces table').count()).toBe(0)
  await box.focus()
  const seen: Picture[] = []
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press('Space')
    if (seen.length > 0) await expect.poll(pixels).not.toEqual(seen.at(-1))
    seen.push(await pixels())
    expect(await page.locator('.forces table').count()).toBe(i % 2 === 0 ? 1 : 0)
  }
  expect(seen[5]).toEqual(seen[3])
  expect(seen[4]).toEqual(seen[2])
  expect(await page.evaluate(() => location.hash)).toBe('')
  expect(problems).toEqual([])
})

test('the legend is that of the selected runner in the row that is shown', async () => {
  const { page, runner, time, figures, line } = await openForces()
  expect(await page.getByRole('heading', { name: 'Forces on the 10 fps block' }).count()).toBe(1)
  expect(await line()).toContain('Static friction holds it: 2.54\u202fN of at most 4.74\u202fN')
  expect(await figures('Friction')).toEqual(['2.54\u202fN', '−2.54\u202fN', '0.00\u202fN'])
  expect(await figures('Sum')).toEqual(Array(3).fill('0.00\u202fN'))

  await runner(1).getByLabel('Integrator').focus()
  await time().fill('0.25')
  expect(await page.getByRole('heading', { name: 'Forces on the 30 fps block' }).count()).toBe(1)
  const { s, v } = simulate(experiment)
  const forces = forcesAt(experiment, { s: s[7]!, v: v[7]! })
  for (const [name, { x, y }] of [
    ['Gravity', forces.gravity],
    ['Normal force', forces.normal],
    ['Friction', forces.friction],
    ['Sum', forces.sum],
    ['Acceleration', forces.acceleration],
  ] as const) {
    const shown = (await figures(name)).map((text) => parseFloat(text.replace('−', '-')))
    expect(shown[0], name).toBeCloseTo(Math.hypot(x, y), 1)
    expect(shown[1], name).toBeCloseTo(x * forces.along.x + y * forces.along.y, 1)
    expect(shown[2], name).toBeCloseTo(x * forces.across.x + y * forces.across.y, 1)
  }
  expect(parseFloat((await figures('Velocity'))[1]!.replace('−', '-'))).toBeCloseTo(v[7]!, 2)
  expect(await line()).toMatch(/N = 0\.5 × 9\.48\u202fN = 4\.74\u202fN/)
})

test('a hidden runner shows nothing, and neither does a block that has left the track', async () => {
  const { page, goTo } = await openForces()
  await page.getByRole('button', { name: 'Hide 10 fps' }).click()
  expect(await page.locator('.forces').innerText()).toContain('The selected runner is hidden.')
  await goTo('#scene=half-pipe&position=3.1&runners=60/explicit-euler')
  await expect
    .poll(() => page.locator('.forces').innerText())
    .toContain('The block has left the track: no forces are computed any more.')
})

test('figures that change move nothing', async () => {
  const { page, time } = await openForces()
  const boxes = async () =>
    page.evaluate(() =>
      [...document.querySelectorAll('.forces table, .parameters')].map((element) => {
        const { left, top, right, bottom } = element.getBoundingClientRect()
        return [left, right, bottom - scrollY, top - scrollY].map(Math.round)
      }),
    )
  await time().fill('0')
  const before = await boxes()
  for (const at of ['0.3', '0.55', '0.7', '1']) {
    await time().fill(at)
    expect(await boxes()).toEqual(before)
  }
})

test.each(
  some(
    [
      [1280, 'light'],
      [1280, 'dark'],
      [390, 'light'],
      [390, 'dark'],
      [320, 'light'],
    ] as const,
    // On a wide page they are among everything in axe.test.ts.
    ...[3, 4],
  ),
)('%d px wide, %s: nothing cut off, axe finds nothing', async (width, colorScheme) => {
  const { page, goTo } = await openForces('', { width, colorScheme, hasTouch: width < 800 })
  for (const address of ['#', '#scene=spring', '#scene=fall&mass=2500']) {
    await goTo(address)
    await page.waitForTimeout(100)
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(width)
    const [table, panel] = await page.evaluate(() =>
      ['.forces table', '.forces'].map(
        (name) => document.querySelector(name)!.getBoundingClientRect().right,
      ),
    )
    expect(table).toBeLessThanOrEqual(panel!)
  }
  expect(await violationsOn(page, 'slide-lab')).toEqual([])
})
