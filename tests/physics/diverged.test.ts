import { describe, expect, it } from 'vitest'
import { rk4 } from '../../src/physics/integrators/rk4.ts'
import { lawOf } from '../../src/physics/law.ts'
import type { Law } from '../../src/physics/law.ts'
import { Motion } from '../../src/physics/motion.ts'
import { advance } from '../../src/physics/step.ts'
import { located } from '../../src/physics/stopping/located.ts'
import { naive } from '../../src/physics/stopping/naive.ts'
import { arcAfter, straight } from '../../src/physics/track.ts'

/** A step from s = 1 m at 2 m/s by a method that ends at a distance and a speed. */
function stepTo(s: number, v: number, end = Infinity): Motion {
  const motion = new Motion(lawOf([straight(0, end)], {}), 1, 2, true)
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
    [1e24, 1],
    [2e24, 1],
    [-2e24, 1],
    [1, 2e15],
    [1, -2e15],
  ])('that ends at %f m and %f m/s has diverged there', (s, v) => {
    expect(stepTo(s, v)).toMatchObject({ s, v, moving: false, outcome: 'diverged' })
  })

  it('that ends beyond the track has left it, unless it has diverged', () => {
    expect(stepTo(2, 1e15, 1.5)).toMatchObject({ s: 2, outcome: 'left-the-track' })
    expect(stepTo(2, 2e15, 1.5)).toMatchObject({ s: 2, outcome: 'diverged' })
    expect(stepTo(2e24, 1, 1.5)).toMatchObject({ s: 2e24, outcome: 'diverged' })
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

/** A step of 0.1 s with events located, from s = 1 m at 2 m/s, by a method that ends as `end` says. */
function locateBy(law: Law, end: (stepped: Motion) => { s: number; v: number }): Motion {
  const motion = new Motion(law, 1, 2, true)
  motion.dt = 0.1
  advance(motion, { ...rk4, step: (stepped) => Object.assign(stepped, end(stepped)) }, located)
  return motion
}

describe('the search for an event gives up, and says so,', () => {
  const rubbed = { gravity: 9.81, muStatic: 0.1, muKinetic: 0.1 }
  const level = lawOf([straight(0, 1.5)], rubbed)
  const spring = lawOf([straight(0)], { ...rubbed, stiffness: 10, position: 1, speed: 2 })
  const hill = straight(0, 0)
  const crest = lawOf([hill, arcAfter(hill, -1 / 3, 3)], rubbed)

  it('where a method flings the block however short its step', () => {
    expect(locateBy(spring, () => ({ s: 1, v: -1000 })).outcome).toBe('diverged')
  })

  it('where the speed jumps over 0', () => {
    expect(locateBy(level, ({ dt }) => ({ s: 1, v: dt < 0.05 ? 1 : -1 })).outcome).toBe('diverged')
  })

  it('where the place jumps over a joint', () => {
    expect(locateBy(level, ({ dt }) => ({ s: dt < 0.05 ? 1 : 2, v: 2 })).outcome).toBe('diverged')
  })

  it('where the press jumps over 0', () => {
    const end = locateBy(crest, ({ dt }) => ({ s: 1.01, v: dt < 0.05 ? 2 : 6 }))
    expect(end.outcome).toBe('diverged')
  })

  it('where a block that sets off has turned back in however short a step', () => {
    const motion = new Motion(spring, 1, 0, true)
    motion.dt = 0.1
    advance(motion, { ...rk4, step: (stepped) => (stepped.v = 1e-3) }, located)
    expect(motion.outcome).toBe('diverged')
  })
})
