import { describe, expect, it } from 'vitest'
import { rk4 } from '../../src/physics/integrators/rk4.ts'
import { lawOf } from '../../src/physics/law.ts'
import { Motion } from '../../src/physics/motion.ts'
import { advance } from '../../src/physics/step.ts'
import { naive } from '../../src/physics/stopping/naive.ts'
import { straight } from '../../src/physics/track.ts'

/** A step from s = 1 m at 2 m/s by a method that ends at a distance and a speed. */
function stepTo(s: number, v: number): Motion {
  const motion = new Motion(lawOf([straight(0)], {}), 1, 2, true)
  motion.dt = 0.1
  const method = {
    ...rk4,
    step: (stepped: Motion) => {
      stepped.s = s
      stepped.v = v
    },
  }
  advance(motion, method, naive)
  return motion
}

describe('a step', () => {
  it('that ends where a motion may be goes on', () => {
    expect(stepTo(1e23, -9e14)).toMatchObject({ s: 1e23, v: -9e14, moving: true })
  })

  it.each([
    [2e24, 1],
    [-2e24, 1],
    [1, 2e15],
    [1, -2e15],
  ])('that ends at %f m and %f m/s has diverged there', (s, v) => {
    expect(stepTo(s, v)).toMatchObject({ s, v, moving: false, outcome: 'diverged' })
  })

  it.each([
    [Infinity, 1],
    [1, Infinity],
    [-Infinity, -1],
    [1, -Infinity],
    [Infinity, -Infinity],
    [NaN, 1],
    [1, NaN],
  ])('that ends at %f m and %f m/s has diverged where it began, which can be drawn', (s, v) => {
    expect(stepTo(s, v)).toMatchObject({ s: 1, v: 2, moving: false, outcome: 'diverged' })
  })
})
