import { describe, expect, test } from 'vitest'
import { begin } from '../../../src/panels/measures/task.ts'
import { Slices } from '../../../src/panels/measures/slices.ts'
import type { TaskReport } from '../../../src/panels/measures/slices.ts'
import { rateMap, spreadMethods, sweep } from '../../../src/measure/index.ts'
import type { MapRequest, SweepRequest } from '../../../src/measure/index.ts'

const clock = () => performance.now()
const request: SweepRequest = {
  experiment: { scene: 'ramp', duration: 0.5 },
  methods: ['velocity-verlet', 'rk4'],
  rates: [10, 20, 30],
  tolerances: [1e-3, 1e-6],
}
const map: MapRequest = {
  ...{ experiment: { scene: 'ramp', duration: 0.5 }, of: 'error', parameter: 'angle' },
  ...{ from: 0, to: 60, slowest: 5, fastest: 240, columns: 9, rows: 7 },
}
const spreads = {
  experiments: [{ scene: 'fall', duration: 0.5 }],
  methods: spreadMethods({ stopping: 'located', timestep: { kind: 'variable' } }),
}

describe('a task', () => {
  test.each([
    { kind: 'sweep', request },
    { kind: 'timing', request },
    { kind: 'map', request: map },
    { kind: 'spreads', request: spreads },
  ])('of the kind $kind yields as often as it says', (task) => {
    // As a message is: JSON and back.
    const { parts, total } = begin(JSON.parse(JSON.stringify(task)), clock)
    expect([...parts]).toHaveLength(total)
  })

  test.each([
    [undefined, 'The task is not an object but undefined.'],
    [{ kind: 'sweep' }, 'The request is not an object but undefined.'],
    [{ kind: 'dance', request: {} }, '“dance” is nothing that can be measured.'],
    [{ kind: 'sweep', request: { ...request, rates: [0] } }, 'A rate: 0 is not in 1…1000.'],
    [{ kind: 'sweep', request: { ...request, rates: 7 } }, 'The rates are not a list'],
    [{ kind: 'sweep', request: { ...request, tolerances: [1] } }, 'A tolerance: 1 is not in'],
    [{ kind: 'timing', request: { ...request, methods: ['rk5'] } }, '“rk5” is not one of'],
    [
      { kind: 'sweep', request: { ...request, experiment: { scene: 'ramp', duration: -1 } } },
      'duration: -1 is not in',
    ],
    [{ kind: 'map', request: { ...map, parameter: 'constructor' } }, 'not a parameter of ramp'],
    [{ kind: 'map', request: { ...map, of: 'colour' } }, 'an error or a spread'],
    [{ kind: 'map', request: { ...map, to: 1e9 } }, 'Angle, to: 1000000000 is not in 0…90.'],
    [{ kind: 'map', request: { ...map, columns: 1e9 } }, 'The columns: 1000000000'],
    [{ kind: 'spreads', request: { ...spreads, methods: [3] } }, 'A method is not an object'],
    [
      { kind: 'spreads', request: { ...spreads, methods: [{ stopping: 'brakes' }] } },
      'stopping: "brakes" is not one of',
    ],
  ])('%j is refused in words', (task, words) => {
    expect(() => begin(task, clock)).toThrow(words)
  })
})

describe('slices', () => {
  /** Everything that is told of a task until it is over. */
  function all(slices: Slices, task: unknown): Promise<TaskReport[]> {
    const reports: TaskReport[] = []
    return new Promise((resolve) =>
      slices.start(task, (report) => {
        reports.push(report)
        if (report.done === 1) resolve(reports)
      }),
    )
  }

  test('tell all of a task, in order', async () => {
    const slices = new Slices(clock)
    const reports = await all(slices, { kind: 'sweep', request })
    const whole = [...sweep(request)].filter((part) => part !== undefined)
    expect(reports.flatMap(({ parts }) => parts)).toEqual(whole)
    const cells = await all(slices, { kind: 'map', request: map })
    expect(cells.flatMap(({ parts }) => parts)).toEqual([...rateMap(map)])
    slices.close()
  })

  test('go to the newest task, and say no more of the one before', async () => {
    // A clock of which each look costs 5 ms: two yields to a slice.
    let now = 0
    const slices = new Slices(() => (now += 5))
    let heard = 0
    const first = new Promise<void>((resolve) =>
      slices.start({ kind: 'map', request: { ...map, rows: 500 } }, () => {
        heard++
        resolve()
      }),
    )
    await first
    const before = heard
    const reports = await all(slices, { kind: 'sweep', request })
    expect(reports.at(-1)!.done).toBe(1)
    expect(reports.length).toBeGreaterThan(2)
    expect(heard).toBe(before)
    slices.close()
  })

  test('stop when they are told to', async () => {
    let now = 0
    const slices = new Slices(() => (now += 5))
    let heard = 0
    slices.start({ kind: 'map', request: { ...map, rows: 500 } }, () => heard++)
    slices.stop()
    await new Promise((resolve) => setTimeout(resolve, 30))
    expect(heard).toBe(0)
    slices.close()
  })

  test('tell in words what is wrong with a task', async () => {
    const slices = new Slices(clock)
    const [report] = await all(slices, { kind: 'sweep', request: { ...request, rates: [] } })
    expect(report).toEqual({
      parts: [],
      done: 1,
      problem: 'The rates are not a list of 1 to 100000.',
    })
    slices.close()
  })
})
