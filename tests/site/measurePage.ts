import type { SweepCurve } from '../../src/measure/index.ts'
import type { Page } from 'playwright-core'
import { opening } from '../../src/lab/state/opening.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { openLab } from './labPage.ts'

const { scene, parameters, duration } = opening
/** The lab as it opens, without its runners. */
export const shared = { scene, parameters, duration } as Experiment
/** What the diagram measures then. */
export const swept = { experiment: { ...shared, stopping: 'located' } } as const

/**
 * The exact motion asks the engine for its sines, whose last bits differ between Node and the browser: by no more than
 * a few ulp of positions of some metres.
 */
export const ENGINES = 1e-13

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
export const holdWorkers = () => {
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
export const forbidWorkers = () => {
  window.Worker = function () {
    throw new DOMException('No workers here.', 'SecurityError')
  } as unknown as typeof Worker
}

/** What countWorkers has counted, in the window. */
export interface Counted {
  workers: Worker[]
  heard: number
}

/** A lab whose measures can be seen. */
export async function openMeasures(
  address = '',
  options: Parameters<typeof openLab>[1] & { prepare?: () => void } = {},
) {
  const { prepare = countWorkers, ...others } = options
  const lab = await openLab(address, others)
  const { page } = lab
  // What is set up here is used when the measures are loaded, which is later.
  await page.evaluate(prepare)
  await page.locator('slide-lab-measures').evaluate((each) => each.scrollIntoView())
  await page.locator('slide-measure-views').waitFor()
  return {
    ...lab,
    view: (name: string) => page.getByRole('button', { name, exact: true }).click(),
    ready: () => ready(page),
    counted: () =>
      page.evaluate(() => {
        const { workers, heard } = window as unknown as Counted
        return { workers: workers.length, heard }
      }),
    area: page.locator('slide-lab-measures .area'),
    readOut: () => page.locator('slide-lab-measures .read-out').innerText(),
  }
}

async function ready(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const measuring = document.querySelector(
      'slide-speed-diagram, slide-rate-map, slide-spread-view',
    ) as unknown as {
      measuring: { busy: boolean; done: number }
    } | null
    return measuring && !measuring.measuring.busy && measuring.measuring.done === 1
  })
}

/** The numbers behind the diagram, as the page has them. */
export function sweptIn(page: Page) {
  return page.evaluate(() => {
    const { swept } = document.querySelector('slide-speed-diagram') as unknown as {
      swept: Map<string, SweepCurve>
    }
    return [...swept.values()].map(
      ({ method, by, settings, errors, rms, evaluations, outcomes }) => ({
        ...{ method, by, settings },
        errors: [...errors],
        rms: [...rms],
        evaluations: [...evaluations],
        outcomes: [...outcomes],
      }),
    )
  })
}

/** Presses keys one after the other. */
export async function press(page: Page, ...keys: string[]): Promise<void> {
  for (const key of keys) await page.keyboard.press(key)
}
