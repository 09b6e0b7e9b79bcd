import { describe, expect, it } from 'vitest'
import {
  cellKinds,
  COARSE,
  coarseCell,
  mappedExperiment,
  presentationErrors,
  rateAt,
  rateMap,
  rowsOf,
  stableRate,
  rowValue,
} from '../../src/measure/index.ts'
import type { MapRequest } from '../../src/measure/index.ts'
import { integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'

const request: MapRequest = {
  experiment: {
    scene: 'ramp',
    parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
    integrator: 'semi-implicit-euler',
    stopping: 'clamped',
    duration: 1,
  },
  of: 'error',
  parameter: 'angle',
  from: 0,
  to: 60,
  slowest: 5,
  fastest: 240,
  columns: 20,
  rows: 17,
}

/** The map when all of it is there. */
function whole(request: MapRequest) {
  const rows = [...rateMap(request)].slice(-request.rows)
  expect(rows.map(({ row }) => row)).toEqual(rows.map((_, i) => i))
  return rows
}

describe('a map', () => {
  it.each(['error', 'spread'] as const)(
    'of the %s is single runs of simulate, to the bit',
    (of) => {
      const asked = { ...request, of }
      for (const { row, values, kinds } of whole(asked))
        for (let column = 0; column < request.columns; column++) {
          const experiment = mappedExperiment(asked, column, row)
          expect(experiment.frames).toEqual({ kind: 'steady', fps: rateAt(asked, column) })
          expect(experiment.parameters).toMatchObject({
            angle: rowValue(asked, row),
            muKinetic: 0.5,
          })
          const run = simulate(experiment)
          const at60 = simulate({ ...experiment, frames: { kind: 'steady', fps: 60 } })
          expect(cellKinds[kinds[column]!]).toBe('measured')
          expect(values[column]).toBe(
            of === 'error'
              ? presentationErrors(run).largest
              : Math.abs(run.drawnS.at(-1)! - at60.drawnS.at(-1)!),
          )
        }
    },
  )

  it('comes coarse first, and those cells are those of the whole', () => {
    const all = [...rateMap(request)]
    expect(all).toHaveLength(rowsOf(request))
    const fine = all.slice(-request.rows)
    const coarse = all.slice(0, -request.rows)
    expect(coarse.map(({ row }) => row)).toEqual([4, 12, 16])
    for (const { row, values, kinds } of coarse) {
      const looked = [...kinds.keys()].filter((column) => cellKinds[kinds[column]!] !== 'pending')
      expect(looked).toEqual([4, 12, 19])
      for (const column of looked) expect(values[column]).toBe(fine[row]!.values[column])
    }
    // Every cell has one of the coarse ones to stand for it.
    for (let i = 0; i < request.columns; i++) {
      expect([4, 12, 19]).toContain(coarseCell(i, request.columns))
      expect(Math.abs(coarseCell(i, request.columns) - i)).toBeLessThanOrEqual(COARSE / 2)
    }
  })

  it('has its axes within their ends, rates logarithmic and round enough to be typed', () => {
    const rates = Array.from({ length: 20 }, (_, column) => rateAt(request, column))
    expect(rates[0]).toBeCloseTo(5 * 48 ** (0.5 / 20), 1)
    expect(rates.at(-1)).toBeLessThan(240)
    for (const rate of rates) expect(String(rate).length).toBeLessThanOrEqual(4)
    expect(rowValue(request, 0)).toBe(1.765)
  })

  it('of the spread holds no run on the track against one that left it', () => {
    // Explicit Euler gains energy the faster the longer its steps: at 60 fps it leaves from near the lip, at 240 later.
    const asked: MapRequest = {
      ...request,
      of: 'spread',
      experiment: { scene: 'half-pipe', integrator: 'explicit-euler', duration: 4 },
      ...{ parameter: 'position', from: 2.4, to: 3.1 },
    }
    const found = new Set<string>()
    for (const { row, kinds, values } of whole(asked))
      for (let column = 0; column < asked.columns; column++) {
        const experiment = mappedExperiment(asked, column, row)
        const kindAt = (fps: number) =>
          simulate({ ...experiment, frames: { kind: 'steady', fps } }).outcome.kind
        const [own, reference] = [kindAt(rateAt(asked, column)), kindAt(60)]
        const expected =
          own === 'left-the-track' ? own : reference === 'moving' ? 'measured' : 'different'
        expect(cellKinds[kinds[column]!]).toBe(expected)
        expect(Number.isFinite(values[column])).toBe(expected === 'measured')
        found.add(expected)
      }
    expect(found).toEqual(new Set(['left-the-track', 'measured', 'different']))
  })

  it('says what can’t be run, what left the track, and what blew up', () => {
    const pipe: Experiment = {
      scene: 'half-pipe',
      parameters: { position: 2.8 },
      integrator: 'explicit-euler',
      duration: 6,
    }
    const kindsOf = (asked: MapRequest) =>
      whole(asked).map(({ kinds }) => [...new Set(kinds)].map((kind) => cellKinds[kind]!))
    const pipes = kindsOf({ ...request, experiment: pipe, parameter: 'radius', from: 0.5, to: 5 })
    // The lip is at πR/2: a pipe of a radius below 1.78 m does not hold a block at 2.8 m.
    expect(pipes[0]).toEqual(['refused'])
    expect(pipes[6]).toContain('left-the-track')
    const spring: Experiment = {
      scene: 'spring',
      parameters: { position: 1.5, muStatic: 0, muKinetic: 0 },
    }
    const springs = kindsOf({
      ...{ ...request, experiment: spring, parameter: 'stiffness', from: 1, to: 4000 },
    })
    expect(springs[16]).toEqual(['diverged', 'measured'])
  })
})

describe('the stability limit over a map', () => {
  const spring = (stiffness: number): Experiment => ({
    scene: 'spring',
    parameters: { angle: 0, stiffness, mass: 2, muStatic: 0, muKinetic: 0, position: 1 },
    // A hundredth beyond its limit a method grows e-fold in some five to ten steps: by all bounds within a few thousand.
    duration: 400,
  })

  it.each(integrators.filter(({ stability }) => stability > 0 && stability < Infinity))(
    'of $id is where runs begin to blow up',
    ({ id }) => {
      const experiment = { ...spring(2000), integrator: id }
      const rate = stableRate(experiment)!
      const kindAt = (fps: number) =>
        simulate({ ...experiment, frames: { kind: 'steady', fps } }).outcome.kind
      expect(kindAt(0.98 * rate)).toBe('diverged')
      expect(kindAt(1.02 * rate)).toBe('moving')
    },
  )

  it('is never, always, or nothing that theory knows', () => {
    expect(stableRate({ ...spring(40), integrator: 'implicit-midpoint' })).toBe(0)
    expect(stableRate({ ...spring(40), integrator: 'explicit-euler' })).toBe(Infinity)
    expect(stableRate({ scene: 'ramp' })).toBeUndefined()
    expect(stableRate({ ...spring(40), timestep: { kind: 'fixed', step: 0.01 } })).toBeUndefined()
  })
})
