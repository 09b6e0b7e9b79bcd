import { describe, expect, test } from 'vitest'
import { layOutDiagram, nearestSpot, spotRows } from '../../../src/panels/measures/diagramLayout.ts'
import { pointName } from '../../../src/panels/measures/diagramWords.ts'
import { labRunners } from '../../../src/panels/measures/labRunners.ts'
import { diagramCurves } from '../../../src/panels/measures/points.ts'
import { openingOf } from '../../../src/lab/state/opening.ts'
import { Simulation } from '../../../src/lab/state/simulation.ts'
import type { RunnerState } from '../../../src/lab/state/state.ts'
import {
  evaluationsPerSecond,
  presentationErrors,
  sweep,
  sweepMethods,
  sweepRates,
} from '../../../src/measure/index.ts'
import type { SweepCurve } from '../../../src/measure/index.ts'
import type { Experiment, SceneId } from '../../../src/physics/index.ts'

const like: RunnerState = {
  frames: { kind: 'steady', fps: 30 },
  timestep: { kind: 'variable' },
  integrator: 'midpoint',
  stopping: 'located',
  paletteIndex: 0,
  hidden: false,
}

/** A lab with these runners in a scene as it opens, or as long as is said. */
function lab(scene: SceneId, runners: readonly Partial<RunnerState>[], duration?: number) {
  const opening = openingOf(scene)
  const state = {
    ...opening,
    duration: duration ?? opening.duration,
    runners: runners.map((each, paletteIndex) => ({ ...like, paletteIndex, ...each })),
  }
  return new Simulation().run(state)
}

function curvesOf(
  scene: SceneId,
  cost: (curve: SweepCurve) => Float64Array = ({ evaluations }) => evaluations,
) {
  const { parameters, duration } = openingOf(scene)
  const experiment = { scene, parameters, duration } as Experiment
  const swept = [...sweep({ experiment, methods: sweepMethods, rates: sweepRates, tolerances: [] })]
  return diagramCurves(
    swept.filter((curve) => curve !== undefined),
    cost,
  )
}

const shared = { stopping: 'located', duration: 6 } as const
const pipe = curvesOf('half-pipe')

describe('a runner of the lab', () => {
  test('stands where its own run is, and on its curve where that is the same run', () => {
    const { runners } = lab('half-pipe', [{}, { stopping: 'naive', integrator: 'explicit-euler' }])
    const placed = labRunners(runners, shared, undefined)
    for (const [i, { point, why }] of placed.entries()) {
      const { trajectory } = runners[i]!
      expect(why).toBe('')
      expect(point!.error).toBe(presentationErrors(trajectory).largest)
      expect(point!.cost).toBe(evaluationsPerSecond(trajectory))
      expect(point!.runner).toMatchObject({ paletteIndex: i, apart: i === 1 })
    }
    const own = pipe.find(({ method }) => method === 'midpoint')!
    const [{ point }] = placed as [(typeof placed)[number]]
    expect(own.points.find(({ setting }) => setting === 30)).toMatchObject({
      error: point!.error,
      cost: point!.cost,
      whole: true,
    })
    // Explicit Euler leaves the track here at 30 fps: no error of it counts.
    expect(placed[1]!.point).toMatchObject({ outcome: 'left-the-track', whole: false })
  })

  const jitter = { kind: 'jitter', fps: 30, amount: 0.5, seed: 1 } as const
  test.each<[string, Partial<RunnerState>, string]>([
    [
      'a fixed step on an unsteady clock',
      {
        frames: jitter,
        timestep: { kind: 'fixed', step: 1 / 60, maxSteps: 1e4, cap: 60, draw: 'latest' },
      },
      '',
    ],
    [
      'parts of steady frames',
      { timestep: { kind: 'substeps', step: 1 / 100, maxSteps: 100_000 } },
      '',
    ],
    ['a cap that no frame reaches', { timestep: { kind: 'capped', cap: 0.1 } }, ''],
    [
      'a step for each frame that is the frame’s',
      { frames: { kind: 'steady', fps: 60 }, timestep: { kind: 'per-frame', step: 1 / 60 } },
      '',
    ],
    ['steps of all lengths', { frames: jitter }, 'its steps differ in length'],
    [
      'a cap that takes time away',
      { timestep: { kind: 'capped', cap: 1 / 60 } },
      'its seconds are not real seconds',
    ],
    [
      'a step for each frame',
      { timestep: { kind: 'per-frame', step: 1 / 60 } },
      'its seconds are not real seconds',
    ],
    [
      'a fixed step that can’t keep up',
      { timestep: { kind: 'fixed', step: 1 / 60, maxSteps: 1, cap: 60, draw: 'latest' } },
      'its seconds are not real seconds',
    ],
  ])('with %s', (_, values, expected) => {
    const [runner] = labRunners(lab('half-pipe', [values]).runners, shared, undefined)
    expect(runner!.why).toBe(expected)
    expect(runner!.point === undefined).toBe(expected !== '')
    if (runner!.point) expect(runner!.point.runner!.apart).toBe(true)
  })

  test('that runs longer than the curves’ runs has no error to be held against theirs', () => {
    const { runners } = lab('ramp', [{}], 30)
    const [runner] = labRunners(runners, { stopping: 'located', duration: 20 }, undefined)
    expect(runner).toMatchObject({
      point: undefined,
      why: 'it runs longer than the curves’ 20\u202fs',
    })
  })

  test('has a time where its very run was timed, as soon as it is known', () => {
    const { runners } = lab('half-pipe', [
      {},
      { frames: { kind: 'steady', fps: 31 } },
      { stopping: 'clamped' },
    ])
    const nanoseconds = Float64Array.from(sweepRates, (rate) => 7 * rate)
    const timed = curvesOf('half-pipe', () => nanoseconds)
    const [same, other, apart] = labRunners(runners, shared, timed)
    expect(same!.point!.cost).toBe(7 * 30)
    for (const each of [other, apart])
      expect(each).toMatchObject({ point: undefined, why: 'its time is not taken' })
    const [waiting] = labRunners(runners, shared, [])
    expect(waiting).toMatchObject({ why: '', point: { cost: NaN } })
  })
})

describe('in the picture', () => {
  const size = { width: 1000, height: 430 }
  const points = (runners: readonly Partial<RunnerState>[]) =>
    labRunners(lab('half-pipe', runners).runners, shared, undefined).map(({ point }) => point!)

  test('a ring is around the point that is the same run, and can be gone to', () => {
    const layout = layOutDiagram(pipe, size, points([{}, { integrator: 'rk8' }]))
    const { drawn, rings } = layout
    const { x, y } = drawn
      .find(({ curve }) => curve.method === 'midpoint')!
      .spots.find(({ point }) => point.setting === 30)!
    expect(rings[0]!.x).toBeCloseTo(x, 9)
    expect(rings[0]!.y).toBeCloseTo(y, 9)
    // What is exact to rounding has its method's row.
    const exact = drawn.find(({ curve }) => curve.method === 'rk8')!.spots.at(-1)!
    expect(rings[1]!.point.error).toBeLessThan(1e-11)
    expect(rings[1]!.y).toBe(exact.y)
    expect(spotRows(layout).at(-1)).toBe(rings)
    expect(pointName(rings[1]!.point)).toBe('Runge–Kutta 8 in the lab, Runge–Kutta 8')
    // A click on both means the curve's, which can be loaded.
    expect(nearestSpot(layout, x, y)!.point.runner).toBeUndefined()
    expect(spotRows(layOutDiagram(pipe, size))).toHaveLength(pipe.length)
  })

  test('everything is inside that is drawn, whatever the runners do', () => {
    const wild: Partial<RunnerState>[] = [
      { frames: { kind: 'steady', fps: 1000 }, integrator: 'rk8' },
      { frames: { kind: 'steady', fps: 2 }, integrator: 'semi-implicit-euler', stopping: 'naive' },
      { frames: { kind: 'steady', fps: 1 }, integrator: 'explicit-euler' },
    ]
    const layout = layOutDiagram(pipe, size, points(wild))
    expect(layout.rings).toHaveLength(3)
    for (const { x, y } of layout.rings) {
      expect(x).toBeGreaterThanOrEqual(layout.left)
      expect(x).toBeLessThanOrEqual(layout.right)
      expect(y).toBeGreaterThanOrEqual(layout.top - 26)
      expect(y).toBeLessThanOrEqual(layout.bottom)
    }
    // What to use is said of the curves alone.
    expect(layout.frontier.every(({ point }) => !point.runner)).toBe(true)
  })

  test('no ring is there before its method’s curve', () => {
    const some = pipe.filter(({ method }) => method !== 'midpoint')
    expect(layOutDiagram(some, size, points([{}])).rings).toHaveLength(0)
  })
})
