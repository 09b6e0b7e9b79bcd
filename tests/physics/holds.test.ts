import { describe, expect, it } from 'vitest'
import { frictionHolds } from '../../src/physics/holds.ts'
import { Chance } from './generated.ts'

describe('static friction', () => {
  it.each([1, -1])('holds up to its limit and at it, against a drive to the side %d', (side) => {
    expect(frictionHolds(side * 2, 3, 2)).toBe(true)
    expect(frictionHolds(side * 3, 3, 3)).toBe(true)
    expect(frictionHolds(side * 3.000001, 3, 3)).toBe(false)
    expect(frictionHolds(side * 4, 3, 4)).toBe(false)
  })

  it('holds where nothing drives, even without any friction', () => {
    expect(frictionHolds(0, 0, 0)).toBe(true)
    expect(frictionHolds(-0, 0, 0)).toBe(true)
    expect(frictionHolds(0, 2, 0)).toBe(true)
    // However little drives: there is nothing to round.
    expect(frictionHolds(Number.MIN_VALUE, 0, Number.MIN_VALUE)).toBe(false)
  })

  it('takes an excess of some roundings for a tie, and one of a few more for what it is, at every size', () => {
    const chance = new Chance(1785)
    for (let i = 0; i < 1000; i++) {
      const most = chance.scale(1e-12, 1e12)
      const beyond = (roundings: number) =>
        frictionHolds(most * (1 + roundings * Number.EPSILON), most, most)
      // Four of the sum of both sides are eight of each.
      expect([beyond(2), beyond(7), beyond(10), beyond(100)], `${most}`).toEqual([
        true,
        true,
        false,
        false,
      ])
    }
  })

  it('knows how large the terms were of which little is left', () => {
    // A spring and gravity, 1e6 m/s² each, that cancel but for 1e-10: an ulp of theirs. That is no excess over 0.
    expect(frictionHolds(1e-10, 0, 2e6)).toBe(true)
    expect(frictionHolds(1e-10, 0, 2e3)).toBe(false)
    expect(frictionHolds(1e-8, 0, 2e6)).toBe(false)
  })

  it('holds no block that is pressed out of the track', () => {
    expect(frictionHolds(0, -1, 0)).toBe(false)
    expect(frictionHolds(0.5, -1, 0.5)).toBe(false)
  })
})
