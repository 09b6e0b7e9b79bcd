import { describe, expect, it } from 'vitest'
import {
  evaluationsPerSecond,
  isExact,
  nanosecondsPerSecond,
  tickOf,
  orderOfCurve,
  outcomeKinds,
  presentationErrors,
  sweep,
  sweepMethods,
  sweepRates,
  sweepTolerances,
  sweptExperiment,
  TIMED_ROUNDS,
  timedSweep,
  tolerantExperiment,
} from '../../src/measure/index.ts'
import type { SweepCurve, SweepRequest } from '../../src/measure/index.ts'
import { integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment, Integrator } from '../../src/physics/index.ts'

const pipe: Experiment = { scene: 'half-pipe', parameters: { position: 1.2 }, duration: 2.5 }
const kick: Experiment = {
  scene: 'ramp',
  parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
  duration: 1,
}

function request(experiment: Experiment): SweepRequest {
  return { experiment, methods: sweepMethods, rates: sweepRates, tolerances: [] }
}

function curves(experiment: Experiment): SweepCurve[] {
  return [...sweep(request(experiment))].filter((curve) => curve !== undefined)
}

function claimOf(id: string): Integrator {
  return integrators.find((each) => each.id === id)!
}

describe('a sweep', () => {
  it('is single runs of simulate, to the bit', () => {
    for (const { method, errors, rms, evaluations, outcomes } of curves(kick))
      for (const [i, rate] of sweepRates.entries()) {
        const run = simulate(sweptExperiment(request(kick), method, rate))
        const single = presentationErrors(run)
        expect(errors[i]).toBe(single.largest)
        expect(rms[i]).toBe(single.rms)
        expect(evaluations[i]).toBe(run.evaluations / run.time.at(-1)!)
        expect(outcomeKinds[outcomes[i]!]).toBe(run.outcome.kind)
      }
  })

  it('to tolerances is runs of the policy, as far as a method of its order gets', () => {
    const asked = { ...request(pipe), rates: [30], tolerances: sweepTolerances }
    const found = [...sweep(asked)].filter((curve) => curve !== undefined)
    const byTolerance = found.filter(({ by }) => by === 'tolerance')
    expect(byTolerance.map(({ method }) => method)).toEqual(sweepMethods)
    for (const { method, settings, errors, evaluations } of byTolerance) {
      const { order } = claimOf(method)
      expect(settings.at(-1)).toBe(order === 1 ? 1e-4 : order === 2 ? 1e-8 : 1e-10)
      for (const [i, tolerance] of settings.entries()) {
        const run = simulate(tolerantExperiment(asked, method, tolerance))
        expect(errors[i]).toBe(presentationErrors(run).largest)
        expect(evaluations[i]).toBe(run.evaluations / 2.5)
      }
      // A smaller error is never had for less.
      const sorted = [...evaluations].sort((a, b) => a - b)
      expect([...evaluations]).toEqual(sorted)
    }
  })

  it('yields between points, and a curve at the end of each method', () => {
    const parts = [...sweep(request(kick))]
    expect(parts).toHaveLength(sweepMethods.length * sweepRates.length)
    expect(parts.flatMap((part) => part?.method ?? [])).toEqual(sweepMethods)
  })

  it.each(curves(pipe))('shows the order that $method claims', (curve) => {
    const { order } = claimOf(curve.method)
    // The next term of the error is a few steps' worth of the first; at 960 steps a second, and for a method of the
    // fourth order at 100, that is below a tenth of an order. One of the eighth comes to rounding in a dozen steps a second.
    expect(Math.abs(orderOfCurve(curve) - order)).toBeLessThan(order > 4 ? 0.2 : 0.1)
  })

  it('through a stop: located keeps every order, or is exact; clamped leaves the first', () => {
    for (const curve of curves(kick)) {
      const { order } = claimOf(curve.method)
      if (order > 1) expect(isExact(curve)).toBe(true)
      else expect(Math.abs(orderOfCurve(curve) - 1)).toBeLessThan(0.1)
    }
    for (const curve of curves({ ...kick, stopping: 'clamped' })) {
      expect(isExact(curve)).toBe(false)
      // Where in its last step the block stops changes from rate to rate: the points scatter about the line.
      expect(Math.abs(orderOfCurve(curve) - 1)).toBeLessThan(0.5)
    }
  })

  it('says of a run that blew up that it did, and fits no order to it', () => {
    const spring = { scene: 'spring', parameters: { stiffness: 1e8, position: 1 }, duration: 1 }
    const [euler] = curves(spring as Experiment)
    expect(euler!.method).toBe('explicit-euler')
    expect([...euler!.outcomes].map((kind) => outcomeKinds[kind])).toEqual(
      sweepRates.map(() => 'diverged'),
    )
    expect(orderOfCurve(euler!)).toBeNaN()
    expect(isExact(euler!)).toBe(false)
  })
})

describe('work', () => {
  it('in evaluations is counted: one a step for a method of one', () => {
    const moving = { scene: 'fall', parameters: { speed: 1 }, duration: 2 } as const
    const run = simulate({ ...moving, integrator: 'semi-implicit-euler' })
    expect(evaluationsPerSecond(run)).toBe(60)
  })

  it('in time is what the clock says, over many runs', () => {
    let now = 0
    let readings = 0
    // Goes on by a quarter of a millisecond whenever it is read: a batch of runs takes that.
    const clock = () => (readings++, (now += 0.25))
    const perSecond = nanosecondsPerSecond({ ...pipe, duration: 2 }, clock, 0.01)
    // Four batches, of one run, two, four and eight, of two seconds each: 1 ms for 30 s.
    expect(readings).toBe(8)
    expect(perSecond).toBeCloseTo(1e6 / 30, 6)
  })

  it.each([0.1, 1, 16.7])('the tick of a clock is found: %d ms', (tick) => {
    let now = 0
    expect(tickOf(() => tick * Math.floor((now += 0.01) / tick))).toBeCloseTo(tick, 9)
  })

  it('in time lasts fifty ticks of a clock of whole milliseconds', () => {
    let real = 0
    let told = 0
    const clock = () => (told = Math.floor((real += 0.45)))
    const perSecond = nanosecondsPerSecond({ ...kick, duration: 0.1 }, clock, 1)
    expect(told).toBeGreaterThanOrEqual(50)
    expect(perSecond).toBeGreaterThan(0)
  })

  it('is not measured with a clock that stands or hardly ticks', () => {
    const short = { ...kick, duration: 0.01 }
    const small = { ...request(short), methods: ['rk4'] as const, rates: [10] }
    let now = 0
    expect(nanosecondsPerSecond(short, () => 5, 1)).toBeNaN()
    expect(() => [...timedSweep(small, () => 5)]).toThrow(/clock stands/)
    expect(() => [...timedSweep(small, () => 16.7 * Math.floor((now += 0.5) / 16.7))]).toThrow(
      /every 16.7.ms, too coarse/,
    )
  })

  it('of a sweep is a positive time for each point', () => {
    const small = { ...request(kick), methods: ['rk4'] as const, rates: [10, 30] }
    const parts = [...timedSweep(small, () => performance.now())]
    const curve = parts.at(-1)!
    expect(parts).toHaveLength(2 * TIMED_ROUNDS)
    expect(parts.filter((part) => part !== undefined)).toHaveLength(TIMED_ROUNDS)
    expect(curve.method).toBe('rk4')
    for (const [i, value] of curve.nanoseconds.entries()) {
      expect(value).toBeGreaterThan(0)
      expect(curve.slowest[i]).toBeGreaterThanOrEqual(value)
    }
  })
})
