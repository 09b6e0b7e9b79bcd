import { describe, expect, test } from 'vitest'
import { costKinds, diagramCurves } from '../../../src/panels/measures/points.ts'
import { layOutDiagram, nearestSpot } from '../../../src/panels/measures/diagramLayout.ts'
import {
  advice,
  leastError,
  pointName,
  pointWords,
} from '../../../src/panels/measures/diagramWords.ts'
import { decadeText, roughSize, sizeText } from '../../../src/chart/magnitudes.ts'
import { logScale } from '../../../src/chart/axis.ts'
import { sweep, sweepMethods, sweepRates, sweepTolerances } from '../../../src/measure/index.ts'
import { integrators } from '../../../src/physics/index.ts'
import type { Experiment } from '../../../src/physics/index.ts'

function curvesOf(experiment: Experiment, tolerances: readonly number[] = []) {
  const swept = [...sweep({ experiment, methods: sweepMethods, rates: sweepRates, tolerances })]
  return diagramCurves(
    swept.filter((curve) => curve !== undefined),
    ({ evaluations }) => evaluations,
  )
}

const kick = curvesOf({
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  duration: 1,
})
const pipe = curvesOf({ scene: 'half-pipe', parameters: { position: 2.8 }, duration: 6 })

describe('the curves', () => {
  test('say what was found of each order', () => {
    // On the ramp a parabola is all there is, and every method of second order or more follows it.
    expect(kick.map(({ label, order }) => [label, order])).toEqual(
      integrators.map(({ label, order }) => [
        label,
        order === 1 ? 'order 1.0' : 'exact to rounding',
      ]),
    )
  })

  test('have points for runs that did not come to their end, which count for nothing', () => {
    const [euler] = pipe
    expect(euler!.points[0]).toMatchObject({ outcome: 'left-the-track', whole: false })
    expect(pointWords(euler!.points[0]!, costKinds[0]!)).toMatch(/^left the track, for /)
    const { frontier, failed, top } = layOutDiagram(pipe, { width: 1000, height: 430 })
    expect(failed).toBe(top)
    expect(frontier.every(({ point }) => point.whole)).toBe(true)
  })
})

describe('the layout', () => {
  test.each([
    ['on a desktop', 1000],
    ['on a phone', 300],
  ])('%s has everything inside, further down where the error is less', (_, width) => {
    for (const curves of [kick, pipe]) {
      const layout = layOutDiagram(curves, { width, height: 430 })
      for (const { spots, labelY } of layout.drawn) {
        for (const { x, y, point } of spots) {
          expect(x).toBeGreaterThanOrEqual(layout.left)
          expect(x).toBeLessThanOrEqual(layout.right)
          expect(y).toBeGreaterThanOrEqual(layout.top - 26)
          expect(y).toBeLessThanOrEqual(layout.bottom)
          if (point.whole && point.error < 1e-11) expect(y).toBeGreaterThan(layout.rounding!)
          else if (point.whole) expect(y).toBeCloseTo(layout.up.at(point.error), 9)
        }
        expect(labelY).toBeLessThanOrEqual(layout.bottom)
      }
      const labels = layout.drawn.map(({ labelY }) => labelY!).sort((a, b) => a - b)
      labels.slice(1).forEach((y, i) => expect(y - labels[i]!).toBeGreaterThan(16.9))
    }
  })

  test('has a curve by tolerance for each method that can be asked, with the name and the row of its method', () => {
    const curves = curvesOf(
      { scene: 'half-pipe', parameters: { position: 1.2 }, duration: 2 },
      sweepTolerances,
    )
    const byTolerance = curves.filter(({ by }) => by === 'tolerance')
    expect(byTolerance).toHaveLength(integrators.length)
    for (const { method, points } of byTolerance) {
      const { order, orderWithSpeed } = integrators.find(({ id }) => id === method)!
      expect(points).toHaveLength(Math.min(8, 4 * Math.min(order, orderWithSpeed) - 2))
      // What is asked for is what comes, give or take: the tolerance for each of two seconds.
      for (const { error, setting } of points) expect(error).toBeLessThan(10 * 2 * setting)
    }
    const layout = layOutDiagram(curves, { width: 1000, height: 430 })
    expect(layout.drawn.filter(({ labelY }) => labelY !== undefined)).toHaveLength(
      integrators.length,
    )
  })

  test('finds the point under a finger', () => {
    const layout = layOutDiagram(kick, { width: 1000, height: 430 })
    const spot = layout.drawn[2]!.spots[4]!
    expect(nearestSpot(layout, spot.x + 2, spot.y - 1)).toBe(spot)
    expect(nearestSpot(layout, 0, 430)).toBeUndefined()
  })
})

describe('the words', () => {
  test('name the cheapest way to an error, each way once', () => {
    expect(advice(kick).map(({ error, point }) => [error, point.method, point.setting])).toEqual([
      ['no error but rounding', 'velocity-verlet', 5],
    ])
    const found = advice(pipe)
    expect(found.map(({ error }) => error)).toContain('1\u202fmm')
    const points = pipe.flatMap(({ points }) => points).filter(({ whole }) => whole)
    for (const { error, point } of found) {
      if (error !== '1\u202fmm') continue
      expect(point.error).toBeLessThanOrEqual(1e-3)
      for (const other of points)
        if (other.cost < point.cost) expect(other.error).toBeGreaterThan(1e-3)
    }
    expect(leastError(kick)).toBeLessThan(1e-11)
  })

  test('name a tolerance where it is the cheapest', () => {
    // Short and quick: a step that is good for the start is far too short for the rest.
    const dive = curvesOf(
      {
        scene: 'fall',
        parameters: { drag: 10, speed: 12 },
        duration: 5,
      },
      [1e-3, 1e-6, 1e-9],
    )
    const found = advice(dive)
    expect(found.some(({ point }) => point.by === 'tolerance')).toBe(true)
    const point = dive.at(-1)!.points.at(-1)!
    expect(pointName(point)).toBe('Implicit midpoint to 1\u202fµm a second')
    expect(pointName(dive[0]!.points[0]!)).toBe('Explicit Euler at 5 steps a second')
  })

  test('of a point', () => {
    const [evaluations] = costKinds
    const [point] = kick[2]!.points
    expect(pointWords(point!, evaluations!)).toBe('exact to rounding, for 7 evaluations a second')
    const coarse = kick[1]!.points[2]!
    expect(pointWords(coarse, evaluations!)).toMatch(
      /^never off by more than 0\.\d\d\u202fm, for \d+ evaluations a second$/,
    )
  })

  test.each([
    [6, '10⁶\u202fm'],
    [1, '10\u202fm'],
    [0, '1\u202fm'],
    [-1, '10\u202fcm'],
    [-2, '1\u202fcm'],
    [-3, '1\u202fmm'],
    [-4, '0.1\u202fmm'],
    [-5, '10\u202fµm'],
    [-6, '1\u202fµm'],
    [-9, '1\u202fnm'],
    [-10, '0.1\u202fnm'],
    [-11, '10\u202fpm'],
  ])('10 to the power of %d metres', (exponent, text) => expect(decadeText(exponent)).toBe(text))

  test.each([
    [0.2543, '0.25\u202fm', '0.254\u202fm'],
    [1.234e-6, '1.2\u202fµm', '1.23\u202fµm'],
    [4.562e-8, '46\u202fnm', '45.6\u202fnm'],
    [3.04e-11, '0.03\u202fnm', '0.0304\u202fnm'],
    [3.04e-13, '0.0003\u202fnm', '0.000304\u202fnm'],
    [0, '0 (to rounding)', '0 (to rounding)'],
  ])('a size of %d m', (value, rough, whole) => {
    expect(roughSize(value)).toBe(rough)
    expect(sizeText(value)).toBe(whole)
  })

  test('a scale has its powers of ten', () => {
    const scale = logScale(0.5, 200, 0, 100)
    expect(scale.decades).toEqual([0, 1, 2])
    expect(scale.at(10)).toBeCloseTo((100 * Math.log(20)) / Math.log(400), 9)
  })
})
