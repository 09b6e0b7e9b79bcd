import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import {
  isExact,
  leastDifference,
  presentationErrorSizes,
  scaleOf,
  sweep,
  withoutRounding,
} from '../../src/measure/index.ts'
import { integrators, parseExperiment, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const scale = (experiment: Experiment) => scaleOf(parseExperiment(experiment))

describe('the scale of a run', () => {
  it('is the length of the true path, a metre at least', () => {
    const slide = (speed: number): Experiment => ({
      scene: 'ramp',
      parameters: { angle: 0, muStatic: 0, muKinetic: 0, speed },
      duration: 10,
    })
    expect(scale(slide(5)).length).toBeCloseTo(50, 12)
    expect(scale(slide(-1e8)).length).toBeCloseTo(1e9, 5)
    expect(scale(slide(1e-12)).length).toBe(1)
  })

  it('is not that of a run that diverges', () => {
    const experiment: Experiment = {
      scene: 'spring',
      parameters: { stiffness: 4000, position: 1, muStatic: 0, muKinetic: 0 },
      frames: { kind: 'steady', fps: 10 },
    }
    const run = simulate(experiment)
    expect(run.outcome.kind).toBe('diverged')
    expect(scaleOf(run.experiment).length).toBeLessThan(1.1)
  })

  it('has the largest energy that moves: ½ m v² and m g h', () => {
    const parameters = { mass: 3, position: 0, speed: -4 }
    const { energy } = scale({ scene: 'fall', parameters, duration: 0.1 })
    expect(energy).toBeGreaterThanOrEqual(0.5 * 3 * 16)
    expect(energy).toBeLessThan(0.5 * 3 * 16 * 1.2)
  })
})

describe('a difference', () => {
  it('is rounding below 1e-11 of the scale, whatever the scale', () => {
    fc.assert(
      fc.property(
        fc.double({ min: 1e-300, max: 1e12, noNaN: true }),
        fc.double({ min: 1e-4, max: 1e4, noNaN: true }),
        fc.boolean(),
        (size, part, negative) => {
          const difference = (negative ? -1 : 1) * part * leastDifference(size)
          if (part < 0.999) expect(withoutRounding(difference, size)).toBe(0)
          if (part > 1.001) expect(withoutRounding(difference, size)).toBe(difference)
        },
      ),
      { seed: 1 },
    )
    expect(withoutRounding(NaN, 1)).toBeNaN()
    expect(withoutRounding(Infinity, 1)).toBe(Infinity)
  })

  // A step rounds s and v by half an ulp of each, v's for the rest of the way: so n steps err by up to n² ulps at the very
  // worst, and by some √n · n as a walk. With 600 steps 1e-11 is 45 000 ulps.
  const exactOnes = integrators.filter(({ order }) => order >= 2)
  it.each(exactOnes)('of $id on a path of 1e9 m is told as on one of a metre', ({ id }) => {
    for (const speed of [0.1, 10, 1e4, 1e7, 1e8, 9e8]) {
      const experiment: Experiment = {
        scene: 'ramp',
        parameters: { speed },
        integrator: id,
        duration: 10,
      }
      const run = simulate(experiment)
      const { largest } = presentationErrorSizes(run)
      expect(withoutRounding(largest, scaleOf(run.experiment).length)).toBe(0)
      const request = { experiment, methods: [id], rates: [5, 30, 60], tolerances: [] }
      const curve = [...sweep(request)].at(-1)!
      expect(isExact(curve)).toBe(true)
    }
  })
})
