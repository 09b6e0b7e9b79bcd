import { describe, expect, it } from 'vitest'
import {
  frameRateSpread,
  presentationErrors,
  spreadOf,
  trajectoryErrors,
} from '../../src/measure/index.ts'
import { integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const kicked: Experiment = {
  scene: 'ramp',
  parameters: { angle: 15, muKinetic: 0.5, muStatic: 0.5, speed: -5 },
  duration: 1.5,
}

describe('the frame-rate spread', () => {
  it('of the paper’s own step is ½aT(Δt₅ − Δt₂₄₀) or more: decimetres on the default ramp', () => {
    const spread = frameRateSpread({
      scene: 'ramp',
      integrator: 'semi-implicit-euler',
      stopping: 'naive',
    })
    // a = g (sin 30° − 0.2 cos 30°) = 3.2059 m/s² for 2 s; the hitches only add to it.
    expect(spread).toBeGreaterThan(0.5 * 3.2059 * 2 * (1 / 5 - 1 / 240) - 1e-3)
  })

  it.each(integrators.filter(({ order }) => order >= 2).map(({ id }) => id))(
    'of %s with located stops is rounding',
    (integrator) => {
      expect(frameRateSpread({ scene: 'ramp', integrator })).toBeLessThan(1e-12)
      expect(frameRateSpread({ ...kicked, integrator })).toBeLessThan(1e-12)
    },
  )

  it('of clamped stops is not, whatever the method', () => {
    for (const { id } of integrators)
      expect(frameRateSpread({ ...kicked, integrator: id, stopping: 'clamped' })).toBeGreaterThan(
        1e-3,
      )
  })

  it('is the largest less the smallest', () => {
    expect(spreadOf([1.64, 1.47, 1.7])).toBeCloseTo(0.23, 12)
    expect(spreadOf([2])).toBe(0)
  })
})

describe('errors', () => {
  it('of the state are taken at the state’s own time, of the picture at the wall clock’s', () => {
    const run = simulate({
      scene: 'ramp',
      timestep: { kind: 'fixed', step: 0.1, draw: 'latest' },
      frames: { kind: 'steady', fps: 24 },
    })
    expect(trajectoryErrors(run).largest).toBeLessThan(1e-12)
    // What is drawn lags by up to a step, at up to 6.4 m/s.
    expect(presentationErrors(run).largest).toBeGreaterThan(0.2)
    expect(presentationErrors(run).largest).toBeLessThan(0.65)
  })

  it('carry their sign: the paper’s step is ahead by ½aTΔt', () => {
    const run = simulate({ scene: 'ramp', integrator: 'semi-implicit-euler' })
    const acceleration = 9.81 * (0.5 - 0.2 * Math.sqrt(0.75))
    const { atEnd, largest, rms, each } = trajectoryErrors(run)
    expect(atEnd).toBeCloseTo((0.5 * acceleration * 2) / 60, 12)
    expect(largest).toBe(atEnd)
    // The error grows evenly from 0: its RMS over the frames tends to a 1/√3 of the last.
    expect(rms / atEnd).toBeCloseTo(1 / Math.sqrt(3), 2)
    expect(each.length).toBe(run.frames + 1)
  })
})
