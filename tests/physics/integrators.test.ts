import { describe, expect, it } from 'vitest'
import { implicitMidpoint } from '../../src/physics/integrators/implicitMidpoint.ts'
import { bareMotion } from './bareMotion.ts'

describe('implicit midpoint', () => {
  const after = (acceleration: (s: number, v: number) => number, v = 1) => {
    const motion = bareMotion(acceleration, { v })
    implicitMidpoint.step(motion)
    return motion
  }

  it('reports an equation that has no solution', () => {
    // v̄ = v + ½ Δt (2 v̄ + 1) at Δt = 1: v̄ is on both sides, and 1 + ½ is left. Every guess misses alike.
    const motion = after((_, v) => 2 * v + 1)
    expect(motion.unsolved).toBe(1)
    // Two looks show that, and no more are taken.
    expect(motion.evaluations).toBe(2)
    expect(Number.isFinite(motion.s)).toBe(true)
    expect(Number.isFinite(motion.v)).toBe(true)
  })

  it('solves one that has, also where a force of the same kind is a little weaker', () => {
    const motion = after((_, v) => 1.5 * v + 1)
    // v̄ (1 − ¾) = 1 + ½
    expect(motion.unsolved).toBe(0)
    expect(motion.s).toBeCloseTo(6, 13)
    expect(motion.v).toBeCloseTo(11, 13)
  })

  it('looks once where nothing acts', () => {
    const motion = after(() => 0)
    expect(motion.evaluations).toBe(implicitMidpoint.evaluations.least)
    expect([motion.s, motion.v]).toEqual([1, 1])
  })

  it('looks once at a block that stands where nothing acts', () => {
    const motion = after(() => 0, 0)
    expect([motion.evaluations, motion.unsolved]).toEqual([1, 0])
    expect([motion.s, motion.v]).toEqual([0, 0])
  })
})
