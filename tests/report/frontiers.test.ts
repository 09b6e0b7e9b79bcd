import { describe, expect, it } from 'vitest'
import { simulate } from '../../src/physics/index.ts'
import { presentationErrorSizes } from '../../src/measure/index.ts'
import { controlledRun } from '../../src/report/frontiers/controlled.ts'
import { compareAt, costAt } from '../../src/report/frontiers/compare.ts'
import { accuracy } from '../../src/report/frontiers/odex.ts'
import { rated, rates } from '../../src/report/frontiers/ours.ts'
import { problems } from '../../src/report/frontiers/problems.ts'
import type { WorkCurve } from '../../src/report/schema/index.ts'

describe.each(problems)('$label', (problem) => {
  const { experiment } = problem

  it('odex is given the right-hand side that our step has', () => {
    const acceleration = problem.acceleration(experiment.parameters)
    for (const [position, speed] of [
      [1.6, 0.1],
      [-0.7, 2.5],
      [0.3, -4],
    ] as const) {
      // A step of explicit Euler changes the speed by a dt.
      const { v } = simulate({
        ...experiment,
        parameters: { ...experiment.parameters, position, speed },
        integrator: 'explicit-euler',
        stopping: 'naive',
        frames: { kind: 'steady', fps: 1000 },
        duration: 1e-3,
      })
      // A speed of some m/s is rounded to 1e-15; a thousand times that is left in the quotient.
      const difference = acceleration(position, speed) - (v[1]! - v[0]!) / 1e-3
      expect(Math.abs(difference)).toBeLessThan(2e-12)
    }
  })

  it('odex comes as near to the truth as it is told to, give or take', () => {
    const errors = [1e-4, 1e-6, 1e-8, 1e-10].map((tolerance) => {
      const { error, converged } = accuracy(problem, tolerance)
      expect(converged).toBe(true)
      return error
    })
    // The tolerance is for a step, and a kink inside a step deceives its estimate: it is kept on the whole, not to the letter.
    expect(errors[0]).toBeLessThan(0.1)
    expect(errors[3]).toBeLessThan(1e-6)
    expect(accuracy(problem, 1e-8).evaluations).toBeGreaterThan(accuracy(problem, 1e-4).evaluations)
  })

  it('ours to tolerance leaves what was asked for, ten times at the most', () => {
    for (const tolerance of [1e-4, 1e-6, 1e-8]) {
      const run = simulate(controlledRun(problem, 'rk4', tolerance))
      const { largest } = presentationErrorSizes(run)
      expect(largest).toBeLessThanOrEqual(10 * tolerance * experiment.duration)
    }
  })

  it.each(rates)('%d steps a second are that many', (rate) => {
    const { steps } = simulate(rated(problem, 'semi-implicit-euler', rate))
    expect(steps).toBe(rate * experiment.duration)
  })
})

describe('the cost of an error', () => {
  const points = [
    { setting: 0.1, error: 1e-2, evaluations: 10, time: 100 },
    { setting: 0.05, error: 1e-4, evaluations: 100, time: 400 },
    { setting: 0.02, error: 1e-3, evaluations: 200, time: 900 },
    { setting: 0.01, error: 1e-6, evaluations: 1000, time: 1600 },
  ]

  it('lies between two points, on a line through their logarithms', () => {
    expect(costAt(points, 1e-3, 'evaluations')).toBeCloseTo(10 ** 1.5, 9)
    expect(costAt(points, 1e-5, 'time')).toBeCloseTo(800, 9)
    expect(costAt(points, 1e-4, 'time')).toBeCloseTo(400, 9)
  })

  it('is that of the cheapest point where all are better, and none where all are worse', () => {
    expect(costAt(points, 1, 'time')).toBe(100)
    expect(costAt(points, 1e-7, 'time')).toBeNull()
    expect(costAt([{ error: 0, time: 7 }], 1e-9, 'time')).toBe(7)
  })

  it('the best of ours and odex are told apart', () => {
    const curve = (id: string, factor: number, slow: number): WorkCurve => ({
      id,
      label: id,
      stopping: null,
      colour: null,
      order: null,
      points: points.map((point) => ({
        ...point,
        evaluations: factor * point.evaluations,
        time: slow * point.time,
      })),
    })
    const at = compareAt([curve('a', 1, 5), curve('b', 2, 1), curve('odex', 0.1, 0.1)], 1e-4)
    expect(at.fewest).toMatchObject({ id: 'a', evaluations: 100 })
    expect(at.quickest).toMatchObject({ id: 'b', time: 400 })
    expect(at.odex).toMatchObject({ id: 'odex', evaluations: 10 })
    expect(compareAt([], 1e-4)).toEqual({ error: 1e-4, fewest: null, quickest: null, odex: null })
  })
})
