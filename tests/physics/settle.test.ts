import { describe, expect, it } from 'vitest'
import { Motion } from '../../src/physics/motion.ts'
import { freely } from '../../src/physics/scenes/law.ts'
import { settle } from '../../src/physics/settle.ts'

/** A step from s = 1 m at 2 m/s that ended at a distance and a speed, settled. */
function settled(s: number, v: number): Motion {
  const motion = new Motion({ ...freely(1), forces: [{ drive: 0, press: 0 }] }, 1, 2)
  motion.begin()
  motion.s = s
  motion.v = v
  settle(motion)
  return motion
}

describe('a step', () => {
  it('that ends where a motion may be goes on', () => {
    expect(settled(1e23, -9e14)).toMatchObject({ s: 1e23, v: -9e14, moving: true })
  })

  it.each([
    [2e24, 1],
    [-2e24, 1],
    [1, 2e15],
    [1, -2e15],
  ])('that ends at %f m and %f m/s has diverged there', (s, v) => {
    expect(settled(s, v)).toMatchObject({ s, v, moving: false, outcome: 'diverged' })
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
    expect(settled(s, v)).toMatchObject({ s: 1, v: 2, moving: false, outcome: 'diverged' })
  })
})
