import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, test } from 'vitest'
import type { LabState } from '../../src/lab/state/state.ts'
import { frameRateSpread, paperMethod } from '../../src/measure/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import type { Report } from '../../src/report/schema/index.ts'
import { some } from '../samples.ts'
import { violationsOn } from './axe.ts'
import { openLab } from './labPage.ts'
import { shared, openMeasures } from './measurePage.ts'

const report = JSON.parse(
  readFileSync(join(import.meta.dirname, '../../public/report/report.json'), 'utf8'),
) as Report

test.each([
  [
    'scene=half-pipe&position=0&speed=8&duration=2&runners=5/explicit-euler;240/explicit-euler',
    /^6\d(\.\d)?\sms \(left the track at 0\.39 to 0\.4\d\ss\)$/,
  ],
  [
    'scene=spring&stiffness=4000&muStatic=0&muKinetic=0&position=1&runners=10/velocity-verlet;240/velocity-verlet',
    /^different outcomes\s\(diverged, (moving|at rest)\)$/,
  ],
])('runs that do not end alike on the track are said not to: %s', async (address, text) => {
  const { spread } = await openLab(address)
  expect(await spread()).toMatch(text)
})

test('the table of spreads has the paper’s step at the top; a number loads its method', async () => {
  const lab = await openMeasures()
  await lab.view('Frame-rate spread')
  await lab.ready()
  const first = lab.page.locator('.spreads tbody tr').first()
  expect(await first.locator('th').innerText()).toContain('The paper’s own step')
  const ramp = first.locator('button').nth(1)
  const spread = frameRateSpread({ ...shared, ...paperMethod } as Experiment)
  expect(await ramp.getAttribute('title')).toContain(`${spread.distance} m`)
  const before = await lab.state()
  await first.locator('button').nth(3).click()
  const state: LabState = await lab.state()
  expect(state.scene).toBe('half-pipe')
  expect(state.runners.map(({ frames }) => frames)).toEqual(
    before.runners.map(({ frames }) => frames),
  )
  for (const runner of state.runners) expect(runner).toMatchObject(paperMethod)
  await lab.page.getByRole('button', { name: 'Undo' }).click()
  expect(await lab.state()).toEqual(before)
  expect(lab.problems).toEqual([])
})

test('nothing of it is loaded before it comes near', async () => {
  const lab = await openLab('', { height: 400 })
  const scripts = () =>
    lab.page.evaluate(() =>
      performance.getEntriesByType('resource').filter(({ name }) => /measureViews/.test(name)),
    )
  expect(await scripts()).toHaveLength(0)
  await lab.page.locator('slide-lab-measures').evaluate((each) => each.scrollIntoView())
  await lab.page.locator('slide-measure-views').waitFor()
  expect(await scripts()).toHaveLength(1)
})

describe('what was measured elsewhere', () => {
  test('is shown from the report', async () => {
    const lab = await openMeasures()
    await lab.page.locator('slide-measured-report summary').click()
    await lab.page.locator('slide-measured-report table').first().waitFor()
    expect(await lab.page.locator('slide-measured-report table').count()).toBe(4)
    const text = await lab.page.locator('slide-measured-report').innerText()
    expect(text).toContain('Measured on')
    // The targets are the report's own.
    for (const { label } of report.targets) expect(text).toContain(label)
    expect(lab.problems).toEqual([])
  })

  test('a table’s heading is as wide as what is seen of it', async () => {
    const lab = await openMeasures('', { width: 390 })
    await lab.page.locator('slide-measured-report summary').click()
    await lab.page.locator('slide-measured-report table').first().waitFor()
    const widths = await lab.page
      .locator('slide-measured-report .scroll')
      .evaluateAll((all) =>
        all.map((each) => [each.querySelector('caption')!.offsetWidth, each.clientWidth]),
      )
    expect(widths).toHaveLength(4)
    for (const [heading, seen] of widths) expect(heading).toBeLessThanOrEqual(seen!)
  })

  test('or it is said that there is none', async () => {
    const lab = await openMeasures()
    await lab.page.route('**/report/report.json', (route) => route.fulfill({ status: 404 }))
    await lab.page.locator('slide-measured-report summary').click()
    await expect
      .poll(() => lab.page.locator('slide-measured-report').innerText())
      .toContain('came without a report')
  })
})

test.each(
  some(
    [
      [1280, 'light'],
      [390, 'light'],
      [1280, 'dark'],
      [390, 'dark'],
    ] as const,
    3,
  ),
)('at %d px axe finds nothing in the %s theme', async (width, colorScheme) => {
  const lab = await openMeasures('scene=half-pipe', { width, colorScheme })
  for (const view of ['Speed against error', 'Frame-rate map', 'Frame-rate spread']) {
    await lab.view(view)
    await lab.ready()
    for (const summary of await lab.page.locator('slide-lab-measures summary').all())
      await summary.click()
    if (view === 'Speed against error')
      await lab.page.locator('slide-measured-report table').first().waitFor()
    expect(await violationsOn(lab.page, 'slide-lab-measures')).toEqual([])
    const width = await lab.page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
    expect(width).toBeLessThanOrEqual(0)
  }
  expect(lab.problems).toEqual([])
})
