import { describe, expect, it } from 'vitest'
import { implicitMidpoint } from '../../src/physics/integrators/implicitMidpoint.ts'
import type { Forces } from '../../src/physics/law.ts'
import { Motion } from '../../src/physics/motion.ts'
import { freely } from '../../src/physics/scenes/law.ts'

describe('implicit midpoint', () => {
  const after = (forces: Forces, dt: number, v = 1) => {
    const motion = new Motion({ ...freely(1), forces: [forces] }, 0, v)
    motion.dt = dt
    implicitMidpoint.step(motion)
    return motion
  }

  it('reports an equation that has no solution', () => {
    // v̄ = v + ½ Δt (2 v̄ + 1) at Δt = 1: v̄ is on both sides, and 1 + ½ is left. Every guess misses alike.
    const motion = after((motion) => {
      motion.drive = 2 * motion.v + 1
    }, 1)
    expect(motion.unsolved).toBe(1)
    // Two looks show that, and no more are taken.
    expect(motion.evaluations).toBe(2)
    expect(Number.isFinite(motion.s)).toBe(true)
    expect(Number.isFinite(motion.v)).toBe(true)
  })

  it('solves one that has, also where a force of the same kind is a little weaker', () => {
    const motion = after((motion) => {
      motion.drive = 1.5 * motion.v + 1
    }, 1)
    // v̄ (1 − ¾) = 1 + ½
    expect(motion.unsolved).toBe(0)
    expect(motion.s).toBeCloseTo(6, 13)
    expect(motion.v).toBeCloseTo(11, 13)
  })

  it('looks once where nothing acts', () => {
    const motion = after((motion) => {
      motion.drive = 0
    }, 1)
    expect(motion.evaluations).toBe(implicitMidpoint.evaluations.least)
    expect([motion.s, motion.v]).toEqual([1, 1])
  })

  it('looks once at a block that stands where nothing acts', () => {
    const motion = after(
      (motion) => {
        motion.drive = 0
      },
      1,
      0,
    )
    expect([motion.evaluations, motion.unsolved]).toEqual([1, 0])
    expect([motion.s, motion.v]).toEqual([0, 0])
  })
})
