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
    const { distance } = frameRateSpread({
      scene: 'ramp',
      integrator: 'semi-implicit-euler',
      stopping: 'naive',
    })
    // a = g (sin 30° − 0.2 cos 30°) = 3.2059 m/s² for 2 s; the hitches only add to it.
    expect(distance).toBeGreaterThan(0.5 * 3.2059 * 2 * (1 / 5 - 1 / 240) - 1e-3)
  })

  it.each(integrators.filter(({ order }) => order >= 2).map(({ id }) => id))(
    'of %s with located stops is rounding',
    (integrator) => {
      expect(frameRateSpread({ scene: 'ramp', integrator }).distance).toBeLessThan(1e-12)
      expect(frameRateSpread({ ...kicked, integrator }).distance).toBeLessThan(1e-12)
    },
  )

  it('of clamped stops is not, whatever the method', () => {
    for (const { id } of integrators)
      expect(
        frameRateSpread({ ...kicked, integrator: id, stopping: 'clamped' }).distance,
      ).toBeGreaterThan(1e-3)
  })

  const pipe = (
    parameters: NonNullable<Experiment['parameters']>,
    rest: Partial<Experiment>,
  ): Experiment => ({
    scene: 'half-pipe',
    parameters,
    ...rest,
  })
  const at = (experiment: Experiment, rates: readonly number[]) =>
    rates.map((fps) => simulate({ ...experiment, frames: { kind: 'steady', fps } }))

  it('of runs that leave at one lip is the time between them', () => {
    // Explicit Euler starts with a step of 8 m/s × 0.2 s at 5 fps, and with one that hardly errs at 240.
    const experiment = pipe(
      { position: 0, speed: 8 },
      { integrator: 'explicit-euler', duration: 2 },
    )
    const { outcomes, agree, distance, earliest, latest } = spreadOf(at(experiment, [5, 240]))
    expect(outcomes).toEqual(['left-the-track'])
    expect(agree).toBe(true)
    expect(distance).toBe(0)
    expect(earliest).toBeCloseTo(0.393, 3)
    expect(latest).toBeCloseTo(0.455, 3)
  })

  // From the bottom at v the lip is crossed at the top speed √(v² − 2gR) > 0, and at rates of 60 and more all see it.
  it.each([6.3, 6.5, 7, 8, 10, 20, 40])(
    'of runs that leave at %d m/s is of no distance',
    (speed) => {
      for (const integrator of ['explicit-euler', 'semi-implicit-euler'] as const) {
        const experiment = pipe({ position: 0, speed }, { integrator, duration: 3 })
        const spread = spreadOf(at(experiment, [60, 120, 240]))
        expect(spread.outcomes).toEqual(['left-the-track'])
        expect(spread.distance).toBeLessThan(1e-11 * spread.scale)
        expect(spread.latest - spread.earliest).toBeGreaterThan(1e-5)
      }
    },
  )

  it('of runs that end differently is none', () => {
    const stiff: Experiment = {
      scene: 'spring',
      parameters: { stiffness: 4000, position: 1, muStatic: 0, muKinetic: 0 },
    }
    const spread = spreadOf(at(stiff, [10, 240]))
    expect(spread.outcomes).toEqual(['diverged', 'moving'])
    expect(spread.agree).toBe(false)
    expect(spreadOf(at(stiff, [5, 10]))).toMatchObject({ outcomes: ['diverged'], agree: true })
  })

  it('of a run at rest and one that moves is a distance: both are on the track', () => {
    const spread = spreadOf(
      at({ ...kicked, timestep: { kind: 'per-frame', step: 1 / 60 } }, [10, 120]),
    )
    expect(spread.outcomes).toEqual(['moving', 'at-rest'])
    expect(spread.agree).toBe(true)
    expect(spread.distance).toBeGreaterThan(0.1)
    expect(spread.latest).toBeNaN()
  })

  it('takes the time from the wall clock where the policy lets the clocks stray', () => {
    // 0.4 s of physics are 24 steps of 1/60 s: 0.4 s at 60 fps, 0.1 s at 240.
    const timestep = { kind: 'per-frame', step: 1 / 60 } as const
    const runs = at(pipe({ position: 0, speed: 8 }, { timestep, duration: 2 }), [60, 240])
    const [slow, fast] = runs.map(({ outcome }) => outcome.time)
    expect(slow).toBe(fast)
    const { earliest, latest } = spreadOf(runs)
    // To a frame of 1/60 s.
    expect(Math.abs(latest - slow!)).toBeLessThan(1 / 60)
    expect(Math.abs(earliest - slow! / 4)).toBeLessThan(1 / 60)
  })

  it('is the largest less the smallest', () => {
    const runs = at({ ...kicked, stopping: 'clamped' }, [10, 30, 120])
    const ends = runs.map(({ drawnS }) => drawnS.at(-1)!)
    expect(spreadOf(runs).distance).toBe(Math.max(...ends) - Math.min(...ends))
    expect(spreadOf(runs.slice(0, 1)).distance).toBe(0)
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
