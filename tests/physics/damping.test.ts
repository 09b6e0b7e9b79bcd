import { describe, expect, it } from 'vitest'
import {
  coast,
  dampings,
  decay,
  decayRate,
  follow,
  framesOfCoasting,
} from '../../src/physics/damping.ts'
import { values } from '../../src/tutorial/facts/index.ts'

/** Some roundings of a relative size of 2⁻⁵³ each. */
const ULPS = 8 * Number.EPSILON

describe('the exponential and the logarithm', () => {
  it('agree with the engine’s within a few ulp', () => {
    for (let x = 0; x < 700; x += 0.37) {
      // Reducing by a rounded ln 2 costs up to half an ulp of x.
      expect(Math.abs(decay(x) / Math.exp(-x) - 1)).toBeLessThan(ULPS + x * Number.EPSILON)
    }
    for (let factor = 0.01; factor <= 1; factor += 0.01)
      expect(Math.abs(decayRate(factor, 60) + 60 * Math.log(factor))).toBeLessThan(60 * 5 * ULPS)
  })

  it('are exact where nothing decays, and 0 where all has', () => {
    expect(decay(0)).toBe(1)
    expect(decayRate(1, 60)).toBe(0)
    expect(decay(1e6)).toBe(0)
    expect(decay(Infinity)).toBe(0)
    expect(decay(NaN)).toBeNaN()
  })
})

describe('damping', () => {
  it('is the exponential to first order in the step, whichever way it is written', () => {
    for (const { id, factor } of dampings) {
      if (id === 'per-frame') continue
      const error = (dt: number) => Math.abs(factor(5, dt) - Math.exp(-5 * dt))
      expect(error(1e-3)).toBeLessThan(0.5 * (5 * 1e-3) ** 2 * 1.01)
    }
  })

  it('never turns a velocity round, however long the step', () => {
    for (const { factor } of dampings) expect(factor(5, 1)).toBeGreaterThanOrEqual(0)
  })

  it('a number a frame does not know the length of the frame', () => {
    const { factor } = dampings.find(({ id }) => id === 'per-frame')!
    expect(factor(5, 1 / 30)).toBe(factor(5, 1 / 144))
    expect(factor(decayRate(0.99, 60), 1)).toBeCloseTo(0.99, 14)
  })

  it('coasts as far as the text says', () => {
    expect(values.coast30()).toBeCloseTo(5 / 6, 10)
    expect(values.coast60()).toBeCloseTo(11 / 12, 10)
    expect(values.coast200()).toBeCloseTo(0.975, 10)
    expect(values.coastTrue()).toBe(1)
    expect(values.kept30()).toBeCloseTo(0.74, 3)
    expect(values.kept60()).toBeCloseTo(0.547, 3)
  })

  it.each(dampings)('$id: each frame damps first and moves then, from 0 on', ({ id, factor }) => {
    const [k, v, fps] = [5, 4, 20]
    const left = factor(k, 1 / fps)
    expect(framesOfCoasting(id, { k, v, fps, frames: 0 })).toEqual([0])
    const path = framesOfCoasting(id, { k, v, fps, frames: 3 })
    expect(path).toHaveLength(4)
    // A geometric series: v/f (r + r² + …).
    const sums = [0, left, left + left ** 2, left + left ** 2 + left ** 3]
    for (const [frame, x] of path.entries())
      expect(Math.abs(x - (v / fps) * sums[frame]!)).toBeLessThanOrEqual(ULPS * x)
  })

  it.each([5, 30, 144])('coasts to the same place at %i frames a second', (fps) => {
    const body = { x: 0, v: 5 }
    for (let i = 0; i < fps; i++) coast(body, 5, 1 / fps)
    expect(body.x).toBeCloseTo(1 - Math.exp(-5), 12)
    expect(body.v).toBeCloseTo(5 * Math.exp(-5), 12)
  })

  it('leaves an undamped body at its speed', () => {
    const body = { x: 1, v: 2 }
    coast(body, 0, 0.5)
    expect(body).toEqual({ x: 2, v: 2 })
  })

  it.each([5, 30, 144])('follows along one path at %i frames a second', (fps) => {
    let x = 0
    for (let i = 0; i < fps; i++) x = follow(x, 1, 3, 1 / fps)
    expect(x).toBeCloseTo(1 - Math.exp(-3), 12)
  })
})
