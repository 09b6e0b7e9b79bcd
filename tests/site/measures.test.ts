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
import { roughSize } from '../../src/figure/measures/scale.ts'
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

/** Nothing that is asked of a worker reaches it before it is let go. */
const holdWorkers = () => {
  const waiting: (() => void)[] = []
  let held = true
  const letGo = () => {
    held = false
    for (const send of waiting.splice(0)) send()
  }
  const hold = () => void (held = true)
  Object.assign(window, { letGo, hold })
  const Original = Worker
  window.Worker = class extends Original {
    override postMessage(message: unknown) {
      const send = () => super.postMessage(message)
      if (held) waiting.push(send)
      else send()
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
    expect(await cells.count()).toBe(
      sweepMethods.length * (sweepRates.length + opening.runners.length),
    )
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

describe('the runners of the lab in the diagram', () => {
  const rings = (page: Page) =>
    page.locator('speed-diagram .ring').evaluateAll((all) =>
      all.map((each) => {
        const circle = each.querySelector('circle:not(.halo)')!
        return {
          x: Number(circle.getAttribute('cx')),
          y: Number(circle.getAttribute('cy')),
          colour: getComputedStyle(circle).stroke,
          isDashed: getComputedStyle(circle).strokeDasharray !== 'none',
        }
      }),
    )
  const ringKey = (page: Page) =>
    page
      .locator('speed-diagram .ring-key')
      .innerText()
      .then((text) => text.replace(/\s+/g, ' '))

  test('have a ring each, in words and in the table too, and follow the lab', async () => {
    const lab = await openMeasures()
    await lab.ready()
    const sizes = opening.runners.map(({ frames, timestep, integrator, stopping }) => {
      const method = { frames, timestep, integrator, stopping }
      return roughSize(presentationErrors(simulate({ ...shared, ...method } as Experiment)).largest)
    })
    await expect.poll(() => rings(lab.page)).toHaveLength(3)
    // They clamp, the curves locate.
    expect((await rings(lab.page)).every(({ isDashed }) => isDashed)).toBe(true)
    expect(new Set((await rings(lab.page)).map(({ colour }) => colour)).size).toBe(3)
    const words = await ringKey(lab.page)
    for (const [i, fps] of [10, 30, 120].entries())
      expect(words).toContain(`${fps} fps ${sizes[i]!.replace(/\s/g, ' ')}`)
    expect(words).toContain('Dashed')
    await lab.page.locator('speed-diagram summary').click()
    const row = lab.page.locator('speed-diagram tbody tr').nth(sweepRates.length)
    expect(await row.locator('th').innerText()).toMatch(/^10 fps\s+in the lab$/)
    expect(await row.locator('td').nth(1).innerText()).toContain(sizes[0]!)
    expect(await row.locator('td').nth(0).innerText()).toBe('')

    // The curves clamp too: each ring is around a point of its method's curve.
    await lab.page
      .getByRole('combobox', { name: 'Stopping rule of the diagram' })
      .selectOption('clamped')
    await expect
      .poll(async () => (await rings(lab.page)).map(({ isDashed }) => isDashed))
      .toEqual([false, false, false])
    await lab.ready()
    const marks = await lab.page
      .locator('speed-diagram [data-method=semi-implicit-euler] .mark')
      .evaluateAll((all) =>
        all.map((mark) => {
          const { e: x, f: y } = (mark as SVGGraphicsElement).transform.baseVal.getItem(0).matrix
          return { x, y }
        }),
      )
    for (const [i, rate] of [10, 30, 120].entries())
      await expect
        .poll(async () => {
          const { x, y } = (await rings(lab.page))[i]!
          const mark = marks[sweepRates.indexOf(rate)]!
          return Math.max(Math.abs(x - mark.x), Math.abs(y - mark.y))
        })
        // Drawn to a hundredth of a pixel.
        .toBeLessThan(0.02)

    await lab.page.getByRole('button', { name: 'Hide 10 fps' }).click()
    await expect.poll(() => rings(lab.page)).toHaveLength(2)
    expect(await ringKey(lab.page)).not.toContain('10 fps')
    expect(lab.problems).toEqual([])
  })

  test('are read by keys, and are in the lab already', async () => {
    const lab = await openMeasures()
    await lab.ready()
    await lab.area.focus()
    await press(lab.page, 'ArrowRight', 'ArrowUp', 'Home', 'ArrowRight')
    expect(await lab.readOut()).toMatch(/^30 fps in the lab, Semi-implicit Euler: never off by /)
    expect(await lab.page.locator('speed-diagram output').textContent()).toMatch(
      /^30 fps in the lab, Semi-implicit Euler: never off by .* evaluations a second\.$/,
    )
    await press(lab.page, 'Enter')
    expect(await lab.state()).toEqual(opening)
    expect(lab.problems).toEqual([])
  })

  test('have none where they are not measured as the curves are, and it is said why', async () => {
    const address =
      'runners=10;30;jitter(fps:30,amount:0.5,seed:1)/rk4;60/per-frame(step:1/50);60/clamped'
    const lab = await openMeasures(address)
    await lab.ready()
    await expect.poll(() => rings(lab.page)).toHaveLength(3)
    const words = await ringKey(lab.page)
    expect(words).toContain('no ring: its steps differ in length')
    expect(words).toContain('no ring: its seconds are not real seconds')
    await lab.view('Time on this device')
    await expect.poll(() => rings(lab.page), { timeout: 20_000 }).toHaveLength(2)
    expect(await ringKey(lab.page)).toContain('no ring: its time is not taken')
    expect(lab.problems).toEqual([])
  })
})

describe.each([
  [1440, false],
  [768, false],
  [768, true],
  [390, true],
  [390, false],
] as const)('at %i px (touch: %s) measuring moves nothing', (width, hasTouch) => {
  // One line of advice; as many as there can be, and what leaves the track; a map with theory's line.
  test.each(['scene=ramp', 'scene=half-pipe&runners=10;30;120', 'scene=spring'])(
    'below %s',
    async (address) => {
      const lab = await openMeasures(address, { width, hasTouch, prepare: holdWorkers })
      const { page } = lab
      const views = ['Speed against error', 'Frame-rate map', 'Frame-rate spread']
      for (const view of address.includes('half-pipe')
        ? [...views, 'Time on this device']
        : views) {
        await page.evaluate(() => (window as unknown as { hold: () => void }).hold())
        if (view === 'Time on this device') await lab.view(views[0]!)
        if (view !== views[0]) await lab.view(view)
        await page.getByRole('progressbar', { name: 'Measuring' }).waitFor()
        const before = await page.evaluate(() => {
          const places = new Set<number>()
          Object.assign(window, { places })
          const measures = document.querySelector('lab-measures')!
          const look = () => {
            const { top } = measures.nextElementSibling!.getBoundingClientRect()
            places.add(Math.round(10 * (top + scrollY)) / 10)
          }
          new ResizeObserver(look).observe(measures.firstElementChild!)
          look()
          return [...places]
        })
        await page.evaluate(() => (window as unknown as { letGo: () => void }).letGo())
        // Errors are measured before times are.
        if (view === 'Time on this device')
          await expect
            .poll(() => page.locator('speed-diagram .curve').count(), { timeout: 20_000 })
            .toBe(sweepMethods.length)
        await lab.ready()
        await page.locator('lab-measures .measure:not([data-busy])').waitFor()
        const after = await page.evaluate(() => [
          ...(window as unknown as { places: Set<number> }).places,
        ])
        expect(after, view).toEqual(before)
      }
      expect(lab.problems).toEqual([])
    },
  )
})

test.each([1440, 390])('at %i px the text’s own diagram keeps its height too', async (width) => {
  const { page, problems } = await openLab('', { width, hasTouch: width < 800 })
  await page.evaluate(holdWorkers)
  const figure = page.locator('slide-figure[name="speed-against-error"]')
  const bar = figure.getByRole('progressbar', { name: 'Measuring' })
  // What comes alive above it on the way may push it out of sight.
  await expect
    .poll(async () => {
      await figure.evaluate((each) => each.scrollIntoView())
      return bar.count()
    })
    .toBe(1)
  const before = await figure.evaluate((each) => {
    const heights = new Set<number>()
    Object.assign(window, { heights })
    const look = () => heights.add((each as HTMLElement).offsetHeight)
    new ResizeObserver(look).observe(each)
    look()
    return [...heights]
  })
  await page.evaluate(() => (window as unknown as { letGo: () => void }).letGo())
  await expect
    .poll(
      async () => {
        await figure.evaluate((each) => each.scrollIntoView())
        return figure.locator('.curve').count()
      },
      { timeout: 20_000 },
    )
    .toBe(sweepMethods.length)
  await expect.poll(() => bar.count()).toBe(0)
  expect(await figure.locator('.advice li').count()).toBeGreaterThan(3)
  const after = await page.evaluate(() => [
    ...(window as unknown as { heights: Set<number> }).heights,
  ])
  expect(after).toEqual(before)
  expect(problems).toEqual([])
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
    // Its colour is the one that the legend says.
    const [painted, told] = await lab.page.evaluate(() => {
      const canvas = document.querySelector<HTMLCanvasElement>('rate-map canvas')!
      const [r, g, b] = canvas.getContext('2d')!.getImageData(80, 60, 1, 1).data
      const swatch = document.querySelector('rate-map .swatch[data-kind=rounding]')!
      return [`rgb(${r}, ${g}, ${b})`, getComputedStyle(swatch).backgroundColor]
    })
    expect(painted).toBe(told)
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
