import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, inject, test } from 'vitest'
import { opening } from '../../src/lab/state/opening.ts'
import {
  presentationErrors,
  sweepMethods,
  sweepRates,
  sweepTolerances,
  sweptExperiment,
  tolerantExperiment,
} from '../../src/measure/index.ts'
import { simulate } from '../../src/physics/index.ts'
import { outOfSight } from './frames.ts'
import { swept, ENGINES, forbidWorkers, openMeasures, sweptIn, press } from './measurePage.ts'
import type { Counted } from './measurePage.ts'

test('the worker loads nothing that needs a page', () => {
  const assets = join(inject('folder'), 'assets')
  const loaded = new Set(readdirSync(assets).filter((name) => /^measureWorker-.*\.js$/.test(name)))
  expect(loaded.size).toBe(1)
  // A set that grows while it is gone through is gone through to its end.
  for (const name of loaded)
    for (const [, other] of readFileSync(join(assets, name), 'utf8').matchAll(/from"\.\/([^"]+)"/g))
      loaded.add(other!)
  const needsPage = (name: string) =>
    readFileSync(join(assets, name), 'utf8').includes('HTMLElement')
  expect([...loaded].filter(needsPage)).toEqual([])
})

describe('speed against error', () => {
  test('is single runs of simulate, in the diagram, in the table and in words', async () => {
    const lab = await openMeasures()
    await lab.ready()
    const curves = await sweptIn(lab.page)
    expect(curves.map(({ method, by }) => [method, by])).toEqual([
      ...sweepMethods.map((id) => [id, 'rate']),
      ...sweepMethods.map((id) => [id, 'tolerance']),
    ])
    for (const { method, by, settings, errors, evaluations } of curves)
      for (const [i, setting] of settings.entries()) {
        const asked = by === 'rate' ? sweptExperiment : tolerantExperiment
        const run = simulate(asked(swept, method as (typeof sweepMethods)[number], setting))
        expect(evaluations[i]).toBe(run.evaluations / run.time.at(-1)!)
        expect(Math.abs(errors[i]! - presentationErrors(run).largest)).toBeLessThan(ENGINES)
      }
    const points = curves.reduce((sum, { settings }) => sum + settings.length, 0)
    expect(points).toBeGreaterThan(sweepMethods.length * sweepRates.length + 40)
    expect(await lab.page.locator('slide-speed-diagram .curve .mark').count()).toBe(points)
    expect(await lab.page.locator('slide-speed-diagram .advice').innerText()).toContain(
      'For no error but rounding, use Velocity Verlet at 5 steps a second.',
    )
    await lab.page.locator('slide-speed-diagram summary').click()
    await lab.page.locator('slide-speed-diagram table').waitFor()
    const cells = lab.page.locator('slide-speed-diagram td')
    expect(await cells.count()).toBe(
      sweepMethods.length * (sweepRates.length + sweepTolerances.length + opening.runners.length),
    )
    expect(await cells.nth(0).innerText()).toMatch(/^0\.\d\d\u202fm\s+\d+$/)
    expect(await cells.nth(2).innerText()).toMatch(/^0 \(to rounding\)\s+7$/)
    expect(lab.problems).toEqual([])
  })

  test('has the same bits from a worker and from the page itself', async () => {
    const byWorker = await openMeasures('scene=half-pipe')
    await byWorker.ready()
    expect(await byWorker.counted()).toMatchObject({ workers: 1 })
    const byPage = await openMeasures('scene=half-pipe', { prepare: forbidWorkers })
    await byPage.ready()
    const curves = await sweptIn(byPage.page)
    expect(curves).toHaveLength(2 * sweepMethods.length)
    expect(await sweptIn(byWorker.page)).toEqual(curves)
    expect(byPage.problems).toEqual([])
  })

  test('is read by keys; Enter loads the run, as one change that can be undone', async () => {
    const lab = await openMeasures()
    await lab.ready()
    await lab.area.focus()
    await press(lab.page, 'ArrowRight', 'ArrowDown', 'ArrowDown', 'ArrowRight', 'ArrowRight')
    expect(await lab.readOut()).toMatch(/^Velocity Verlet at 10 steps a second: exact to rounding/)
    expect(await lab.page.locator('slide-speed-diagram output').textContent()).toMatch(
      /^Velocity Verlet at 10 steps a second: exact to rounding, for \d+ evaluations a second\.$/,
    )
    await press(lab.page, 'Enter')
    const state = await lab.state()
    const { paletteIndex, hidden, ...method } = state.runners[0]!
    expect({ paletteIndex, hidden }).toEqual({ paletteIndex: 0, hidden: false })
    expect(method).toEqual({
      frames: { kind: 'steady', fps: 10 },
      timestep: { kind: 'variable' },
      integrator: 'velocity-verlet',
      stopping: 'located',
    })
    expect(state.runners.slice(1)).toEqual(opening.runners.slice(1))
    expect(state.parameters).toEqual(opening.parameters)
    expect(await lab.page.locator('.preset-note').innerText()).toContain('Velocity Verlet at 10')
    await press(lab.page, 'Control+z')
    expect(await lab.state()).toEqual(opening)
    expect(lab.problems).toEqual([])
  })

  test('is read by pointing, and a click loads the point', async () => {
    const lab = await openMeasures()
    await lab.ready()
    const mark = lab.page.locator('slide-speed-diagram [data-method=rk4] .mark').nth(5)
    const box = (await mark.boundingBox())!
    await lab.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2)
    await expect
      .poll(lab.readOut, { timeout: 20_000 })
      .toMatch(/^Runge–Kutta 4 at 30 steps a second/)
    await lab.page.mouse.down()
    await lab.page.mouse.up()
    await expect
      .poll(async () => (await lab.state()).runners[0])
      .toMatchObject({ integrator: 'rk4', frames: { fps: 30 } })
    // The points are the same: nothing is measured again.
    expect(await lab.page.locator('slide-speed-diagram [data-busy]').count()).toBe(0)
  })

  test('follows the lab, newest wish first, and then rests', async () => {
    const lab = await openMeasures()
    await lab.ready()
    for (const angle of [20, 25, 28, 33, 40])
      await lab.page.evaluate((angle) => {
        const lab = document.querySelector('slide-lab') as unknown as {
          change: (change: object) => void
        }
        lab.change({ kind: 'parameters', values: { angle } })
        return new Promise((resolve) => setTimeout(resolve, 130))
      }, angle)
    await lab.ready()
    const [euler] = await sweptIn(lab.page)
    const run = simulate(
      sweptExperiment(
        { experiment: { ...swept.experiment, parameters: { ...opening.parameters, angle: 40 } } },
        'explicit-euler',
        5,
      ),
    )
    expect(Math.abs(euler!.errors[0]! - presentationErrors(run).largest)).toBeLessThan(ENGINES)
    const { workers, heard } = await lab.counted()
    expect(workers).toBe(1)
    await lab.page.waitForTimeout(400)
    expect((await lab.counted()).heard).toBe(heard)
  })

  test('takes times, can be cancelled, and leaves nothing running then', async () => {
    const lab = await openMeasures()
    await lab.ready()
    await lab.view('Time on this device')
    await lab.page.getByRole('progressbar', { name: 'Measuring' }).waitFor()
    await lab.page.getByRole('button', { name: 'Cancel' }).click()
    await expect.poll(() => lab.page.locator('.progress').innerText()).toContain('Cancelled.')
    // What was on its way is one slice.
    await lab.page.waitForTimeout(100)
    const { heard } = await lab.counted()
    await lab.page.waitForTimeout(400)
    expect((await lab.counted()).heard).toBe(heard)
    await lab.page.getByRole('button', { name: 'Measure', exact: true }).click()
    await lab.ready()
    const times = await lab.page.evaluate(() => {
      const { timed } = document.querySelector('slide-speed-diagram') as unknown as {
        timed: Map<string, { nanoseconds: Float64Array }>
      }
      return [...timed.values()].flatMap(({ nanoseconds }) => [...nanoseconds])
    })
    const curves = await sweptIn(lab.page)
    expect(times).toHaveLength(curves.reduce((sum, { settings }) => sum + settings.length, 0))
    for (const time of times) expect(time).toBeGreaterThan(0)
    expect(lab.problems).toEqual([])
  })

  test('goes on in another worker when one dies without a word, and says so', async () => {
    const lab = await openMeasures()
    await lab.ready()
    await lab.page.evaluate(() => (window as unknown as Counted).workers[0]!.terminate())
    await lab.view('Time on this device')
    await expect
      .poll(() => lab.page.locator('.progress').innerText(), { timeout: 20_000 })
      .toContain('Measuring had stopped on its own, and was started again.')
    await lab.ready()
    expect(await lab.counted()).toMatchObject({ workers: 2 })
  })

  test('measures nothing that can’t be seen', async () => {
    const lab = await openMeasures()
    await lab.ready()
    await lab.page.evaluate(() => scrollTo(0, 0))
    await outOfSight(lab.page.locator('slide-lab-measures'))
    const { heard } = await lab.counted()
    await lab.page.evaluate(() => {
      const lab = document.querySelector('slide-lab') as unknown as {
        change: (change: object) => void
      }
      lab.change({ kind: 'parameters', values: { angle: 31 } })
    })
    await lab.page.waitForTimeout(500)
    expect((await lab.counted()).heard).toBe(heard)
    await lab.page.locator('slide-lab-measures').evaluate((each) => each.scrollIntoView())
    await expect.poll(async () => (await lab.counted()).heard).toBeGreaterThan(heard)
  })
})
