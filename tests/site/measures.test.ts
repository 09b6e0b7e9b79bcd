import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { AxeBuilder } from '@axe-core/playwright'
import type { Page } from 'playwright-core'
import { describe, expect, test } from 'vitest'
import type { LabState } from '../../src/figure/state.ts'
import {
  frameRateSpread,
  mappedExperiment,
  paperMethod,
  presentationErrors,
  rateAt,
  sweepMethods,
  sweepRates,
  sweptExperiment,
  valueAt,
} from '../../src/measure/index.ts'
import type { MapRequest } from '../../src/measure/index.ts'
import { opening } from '../../src/figure/opening.ts'
import { simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import type { Report } from '../../src/report/schema.ts'
import { openLab } from './labPage.ts'

const report = JSON.parse(
  readFileSync(join(import.meta.dirname, '../../public/report/report.json'), 'utf8'),
) as Report

const { scene, parameters, duration } = opening
const shared = { scene, parameters, duration } as Experiment
const swept = { experiment: { ...shared, stopping: 'located' } } as const

// The exact motion asks the engine for its sines, whose last bits differ between Node and the browser: by no more than
// a few ulp of positions of some metres.
const ENGINES = 1e-13

/** Keeps every worker, and counts what it says. */
const countWorkers = () => {
  const workers: Worker[] = []
  const Original = Worker
  Object.assign(window, { workers, heard: 0 })
  window.Worker = class extends Original {
    constructor(url: string | URL, options?: WorkerOptions) {
      super(url, options)
      workers.push(this)
      this.addEventListener('message', () => (window as unknown as { heard: number }).heard++)
    }
  }
}

/** A page that can have no workers. */
const forbidWorkers = () => {
  window.Worker = function () {
    throw new DOMException('No workers here.', 'SecurityError')
  } as unknown as typeof Worker
}

interface Counted {
  workers: Worker[]
  heard: number
}

/** A lab whose measures can be seen. */
async function openMeasures(
  address = '',
  options: Parameters<typeof openLab>[1] & { prepare?: () => void } = {},
) {
  const { prepare = countWorkers, ...others } = options
  const lab = await openLab(address, others)
  const { page } = lab
  // What is set up here is used when the measures are loaded, which is later.
  await page.evaluate(prepare)
  await page.locator('lab-measures').evaluate((each) => each.scrollIntoView())
  await page.locator('measure-views').waitFor()
  return {
    ...lab,
    view: (name: string) => page.getByRole('button', { name, exact: true }).click(),
    ready: () => ready(page),
    counted: () =>
      page.evaluate(() => {
        const { workers, heard } = window as unknown as Counted
        return { workers: workers.length, heard }
      }),
    area: page.locator('lab-measures .area'),
    readOut: () => page.locator('lab-measures .read-out').innerText(),
  }
}

async function ready(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const measuring = document.querySelector('speed-diagram, rate-map, spread-view') as unknown as {
      measuring: { busy: boolean; done: number }
    } | null
    return measuring && !measuring.measuring.busy && measuring.measuring.done === 1
  })
}

/** The numbers behind the diagram, as the page has them. */
function sweptIn(page: Page) {
  return page.evaluate(() => {
    const { swept } = document.querySelector('speed-diagram') as unknown as {
      swept: Map<string, Record<string, Float64Array | string>>
    }
    return [...swept].map(([method, { errors, rms, evaluations, outcomes }]) => ({
      method,
      errors: [...(errors as Float64Array)],
      rms: [...(rms as Float64Array)],
      evaluations: [...(evaluations as Float64Array)],
      outcomes: [...(outcomes as Float64Array)],
    }))
  })
}

async function press(page: Page, ...keys: string[]): Promise<void> {
  for (const key of keys) await page.keyboard.press(key)
}

describe('speed against error', () => {
  test('is single runs of simulate, in the diagram, in the table and in words', async () => {
    const lab = await openMeasures()
    await lab.ready()
    const curves = await sweptIn(lab.page)
    expect(curves.map(({ method }) => method)).toEqual(sweepMethods)
    for (const { method, errors, evaluations } of curves)
      for (const [i, rate] of sweepRates.entries()) {
        const run = simulate(sweptExperiment(swept, method as (typeof sweepMethods)[number], rate))
        expect(evaluations[i]).toBe(run.evaluations / run.time.at(-1)!)
        expect(Math.abs(errors[i]! - presentationErrors(run).largest)).toBeLessThan(ENGINES)
      }
    expect(await lab.page.locator('speed-diagram .curve .mark').count()).toBe(
      sweepMethods.length * sweepRates.length,
    )
    expect(await lab.page.locator('speed-diagram .advice').innerText()).toContain(
      'For no error but rounding, use Velocity Verlet at 5 steps a second.',
    )
    await lab.page.locator('speed-diagram summary').click()
    await lab.page.locator('speed-diagram table').waitFor()
    const cells = lab.page.locator('speed-diagram td')
    expect(await cells.count()).toBe(sweepMethods.length * sweepRates.length)
    expect(await cells.nth(0).innerText()).toMatch(/^0\.\d\d\u2009m\s+\d+$/)
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
    expect(curves).toHaveLength(sweepMethods.length)
    expect(await sweptIn(byWorker.page)).toEqual(curves)
    expect(byPage.problems).toEqual([])
  })

  test('is read by keys; Enter loads the run, as one change that can be undone', async () => {
    const lab = await openMeasures()
    await lab.ready()
    await lab.area.focus()
    await press(lab.page, 'ArrowRight', 'ArrowDown', 'ArrowDown', 'ArrowRight', 'ArrowRight')
    expect(await lab.readOut()).toMatch(/^Velocity Verlet at 10 steps a second: exact to rounding/)
    expect(await lab.page.locator('speed-diagram output').textContent()).toMatch(
      /^Velocity Verlet at 10 steps a second: exact to rounding, for \d+ evaluations a second\.$/,
    )
    await press(lab.page, 'Enter')
    const state = await lab.state()
    const { look, hidden, ...method } = state.runners[0]!
    expect({ look, hidden }).toEqual({ look: 0, hidden: false })
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
    const mark = lab.page.locator('speed-diagram [data-method=rk4] .mark').nth(5)
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
    expect(await lab.page.locator('speed-diagram [data-busy]').count()).toBe(0)
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
        { experiment: { ...swept.experiment, parameters: { ...parameters, angle: 40 } } },
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
      const { timed } = document.querySelector('speed-diagram') as unknown as {
        timed: Map<string, { nanoseconds: Float64Array }>
      }
      return [...timed.values()].flatMap(({ nanoseconds }) => [...nanoseconds])
    })
    expect(times).toHaveLength(sweepMethods.length * sweepRates.length)
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
    await lab.page.waitForTimeout(300)
    const { heard } = await lab.counted()
    await lab.page.evaluate(() => {
      const lab = document.querySelector('slide-lab') as unknown as {
        change: (change: object) => void
      }
      lab.change({ kind: 'parameters', values: { angle: 31 } })
    })
    await lab.page.waitForTimeout(500)
    expect((await lab.counted()).heard).toBe(heard)
    await lab.page.locator('lab-measures').evaluate((each) => each.scrollIntoView())
    await expect.poll(async () => (await lab.counted()).heard).toBeGreaterThan(heard)
  })
})

describe('the frame-rate map', () => {
  test('is single runs of simulate; a click loads the one under it', async () => {
    const lab = await openMeasures()
    await lab.view('Frame-rate map')
    await lab.ready()
    const read = await lab.page.evaluate(() => {
      const { cells } = document.querySelector('rate-map') as unknown as {
        cells: {
          request: MapRequest
          cell: (column: number, row: number) => { kind: string; value: number }
        }
      }
      const places = [
        [0, 0],
        [80, 60],
        [33, 100],
        [159, 119],
      ] as const
      return {
        request: cells.request,
        cells: places.map(([column, row]) => ({ column, row, ...cells.cell(column, row) })),
      }
    })
    const { request } = read
    expect(request).toMatchObject({ parameter: 'angle', columns: 160, rows: 120 })
    for (const { column, row, kind, value } of read.cells) {
      expect(kind).toBe('measured')
      const { largest } = presentationErrors(simulate(mappedExperiment(request, column, row)))
      expect(Math.abs(value - largest)).toBeLessThan(ENGINES)
    }
    const canvas = (await lab.page.locator('rate-map canvas').boundingBox())!
    await lab.page.mouse.click(
      canvas.x + ((40 + 0.5) / 160) * canvas.width,
      canvas.y + canvas.height - ((90 + 0.5) / 120) * canvas.height,
    )
    await expect.poll(async () => (await lab.state()).parameters.angle).toBe(valueAt(request, 90))
    expect((await lab.state()).runners[0]!.frames).toEqual({
      kind: 'steady',
      fps: rateAt(request, 40),
    })
    await lab.page.getByRole('button', { name: 'Undo' }).click()
    expect(await lab.state()).toEqual(opening)
    expect(lab.problems).toEqual([])
  })

  test('is read by keys, has a table, and a legend for what blew up', async () => {
    const lab = await openMeasures('scene=spring&runners=30/located')
    await lab.view('Frame-rate map')
    await lab.ready()
    expect(await lab.page.locator('rate-map .limit').count()).toBe(1)
    expect(await lab.page.locator('.map-legend').innerText()).toContain('blew up')
    expect(await lab.readOut()).toMatch(/^Of all runs, .* blows up/)
    await lab.area.focus()
    await press(lab.page, 'ArrowUp', 'Shift+ArrowLeft')
    expect(await lab.readOut()).toMatch(/fps, stiffness \d+\u2009N\/m: the run /)
    await press(lab.page, 'Enter')
    await expect.poll(async () => (await lab.state()).parameters.stiffness).toBeGreaterThan(1000)
    await lab.page.locator('rate-map summary').click()
    await lab.page.locator('rate-map table').waitFor()
    expect(await lab.page.locator('rate-map tbody tr').count()).toBe(6)
    expect(await lab.page.locator('rate-map tbody td').count()).toBe(48)
    expect(lab.problems).toEqual([])
  })

  test('of another parameter, another method, and of the spread', async () => {
    const lab = await openMeasures()
    await lab.view('Frame-rate map')
    await lab.ready()
    await lab.page.getByRole('combobox', { name: 'Parameter of the map' }).selectOption('speed')
    await lab.page
      .getByRole('combobox', { name: 'Integrator of the map' })
      .selectOption('velocity-verlet')
    await lab.page
      .getByRole('combobox', { name: 'Stopping rule of the map' })
      .selectOption('located')
    await expect
      .poll(lab.readOut, { timeout: 20_000 })
      .toBe('Of all runs, 100\u202f% is exact to rounding.')
    await lab.view('Spread against 60 fps')
    await expect
      .poll(lab.readOut, { timeout: 20_000 })
      .toBe('Of all runs, 100\u202f% ends the same to rounding.')
    await lab.page.getByRole('combobox', { name: 'Time step of the map' }).selectOption('fixed')
    await expect.poll(lab.readOut, { timeout: 20_000 }).not.toContain('100')
    expect(lab.problems).toEqual([])
  })
})

test('the table of spreads has the paper’s step at the top; a number loads its method', async () => {
  const lab = await openMeasures()
  await lab.view('Frame-rate spread')
  await lab.ready()
  const first = lab.page.locator('.spreads tbody tr').first()
  expect(await first.locator('th').innerText()).toContain('The paper’s own step')
  const ramp = first.locator('button').nth(1)
  const spread = frameRateSpread({ ...shared, ...paperMethod } as Experiment)
  expect(await ramp.getAttribute('title')).toContain(`${spread} m`)
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
  await lab.page.locator('lab-measures').evaluate((each) => each.scrollIntoView())
  await lab.page.locator('measure-views').waitFor()
  expect(await scripts()).toHaveLength(1)
})

describe('what was measured elsewhere', () => {
  test('is shown from the report', async () => {
    const lab = await openMeasures()
    await lab.page.locator('measured-report summary').click()
    await lab.page.locator('measured-report table').first().waitFor()
    expect(await lab.page.locator('measured-report table').count()).toBe(4)
    const text = await lab.page.locator('measured-report').innerText()
    expect(text).toContain('Measured on')
    // What was asked for and where the time went are the report's own.
    for (const { label } of report.targets) expect(text).toContain(label)
    for (const { what } of report.profiles) expect(text).toContain(what)
    expect(lab.problems).toEqual([])
  })

  test('a table’s heading is as wide as what is seen of it', async () => {
    const lab = await openMeasures('', { width: 390 })
    await lab.page.locator('measured-report summary').click()
    await lab.page.locator('measured-report table').first().waitFor()
    const widths = await lab.page
      .locator('measured-report .scroll')
      .evaluateAll((all) =>
        all.map((each) => [each.querySelector('caption')!.offsetWidth, each.clientWidth]),
      )
    expect(widths).toHaveLength(4)
    for (const [heading, seen] of widths) expect(heading).toBeLessThanOrEqual(seen!)
  })

  test('or it is said that there is none', async () => {
    const lab = await openMeasures()
    await lab.page.route('**/report/report.json', (route) => route.fulfill({ status: 404 }))
    await lab.page.locator('measured-report summary').click()
    await expect
      .poll(() => lab.page.locator('measured-report').innerText())
      .toContain('came without a report')
  })
})

describe.each(['light', 'dark'] as const)('axe finds nothing in the %s theme', (colorScheme) => {
  test.each([1280, 390])('at %d px', async (width) => {
    const lab = await openMeasures('scene=half-pipe', { width, colorScheme })
    for (const view of ['Speed against error', 'Frame-rate map', 'Frame-rate spread']) {
      await lab.view(view)
      await lab.ready()
      for (const summary of await lab.page.locator('lab-measures summary').all())
        await summary.click()
      if (view === 'Speed against error')
        await lab.page.locator('measured-report table').first().waitFor()
      const { violations } = await new AxeBuilder({ page: lab.page })
        .include('lab-measures')
        .analyze()
      expect(
        violations.map(({ id, help, nodes }) => [id, help, ...nodes.map((node) => node.html)]),
      ).toEqual([])
      const width = await lab.page.evaluate(() => document.documentElement.scrollWidth - innerWidth)
      expect(width).toBeLessThanOrEqual(0)
    }
    expect(lab.problems).toEqual([])
  })
})
