/** The reference at the edge of a case: a block put down, ties, and the extremes of what can be set. */
import { describe, expect, it } from 'vitest'
import { exactTrack } from '../../src/physics/exact/track.ts'
import { Random } from '../../src/physics/random.ts'
import { straight } from '../../src/physics/track.ts'
import { samples } from '../samples.ts'
import { at, bare, byId, halfPipe, ramp, runOut } from './exactly.ts'

describe('a block put down', () => {
  const parameters = { ...bare, gravity: 10 }

  it('at the very lip of a pipe falls back into it', () => {
    const lip = Math.PI / 2
    const bottom = { at: 0, x: 0, y: 0, slope: 0, sin: 0, cos: 1 }
    const pipe = [{ ...bottom, from: -lip, to: lip, curvature: 1 }]
    for (const side of [1, -1]) {
      const motion = exactTrack(pipe, { ...parameters, position: side * lip })
      const { s, v } = at(motion, 0.1)
      // It falls freely at first: ½ g t².
      expect(lip - side * s).toBeCloseTo(0.05, 3)
      expect(side * v).toBeCloseTo(-1, 2)
    }
  })

  it('is held at the very limit of static friction, and not beyond it', () => {
    // In numbers that are exact: drive 10 · ¾, press 10 · ½.
    const slope = { ...straight(30), sin: 0.75, cos: 0.5 }
    const at1 = (muStatic: number) => at(exactTrack([slope], { ...parameters, muStatic }), 1).s
    expect(at1(1.5)).toBe(0)
    expect(at1(1.4999)).toBeCloseTo(0.5 * 7.5, 12)
  })
})

describe('a tie of drive and static friction', () => {
  const gravities = [9.81, 10, 1.7]

  it('holds on a straight and on a bend', () => {
    // tan is steep near 90°, where an ulp of the angle is many of the coefficient.
    for (let degrees = 1; degrees <= 75; degrees++)
      for (const gravity of gravities) {
        const angle = degrees * (Math.PI / 180)
        const friction = { gravity, muStatic: Math.tan(angle), muKinetic: 0.5 * Math.tan(angle) }
        expect(at(ramp({ angle: degrees, ...friction }), 100)).toEqual({ s: 0, v: 0 })
        for (const radius of [0.3, 1, 2]) {
          const position = radius * angle
          const motion = halfPipe({ radius, position, ...friction })
          expect(at(motion, 100)).toEqual({ s: position, v: 0 })
        }
      }
  })

  it('holds at 45° with μs = 1, and on the flat without friction', () => {
    for (const gravity of gravities) {
      const still = { s: 0, v: 0 }
      expect(at(ramp({ angle: 45, gravity, muStatic: 1, muKinetic: 1 }), 10)).toEqual(still)
      expect(at(runOut({ angle: 45, gravity, muStatic: 1 }), 10)).toEqual(still)
      expect(at(ramp({ angle: 0, gravity }), 10)).toEqual(still)
      expect(at(halfPipe({ gravity }), 10)).toEqual(still)
    }
  })
})

describe('extremes', () => {
  it('the least speed there is, where no force follows from it, goes on as it is', () => {
    const motion = halfPipe({ radius: 1e6, gravity: 1e6, speed: -5e-324 })
    expect(at(motion, 1e6)).toEqual({ s: -5e-324 * 1e6, v: -5e-324 })
  })

  const random = new Random(3)
  const pick = <T>(values: readonly T[]): T => values[random.next() % values.length]!
  const tiny = [5e-324, 1e-300, 1e-200, 1e-9]
  const pickOf = {
    angle: () => pick([0, ...tiny, 30, 89.999999999, 90]),
    gravity: () => pick([0, ...tiny, 9.81, 1e6]),
    muStatic: () => pick([0, ...tiny, 1, 1000, 1e6]),
    muKinetic: () => pick([0, 0.01, 1, 1000, 1e6]),
    speed: () => pick([-1, 1]) * pick([0, ...tiny, 1, 1e9]),
    length: () => pick([0, ...tiny, 4, 1e6]),
    bendRadius: () => pick([0.001, 1.5, 1e6]),
    radius: () => pick([0.001, 2, 1e6]),
    mass: () => 1,
  }
  const draw = () => Object.fromEntries(Object.entries(pickOf).map(([name, of]) => [name, of()]))

  it.each(['ramp', 'run-out', 'half-pipe'])('neither hang nor make NaN: %s', (id) => {
    for (let i = 0; i < samples(1000); i++) {
      const parameters = draw()
      const quarter = (Math.PI / 2) * parameters['radius']!
      const position =
        pick([-1, 1]) *
        pick(
          id === 'half-pipe'
            ? [0, 5e-324, 0.5 * quarter, 0.9999999 * quarter]
            : [0, 5e-324, 4, 1e9],
        )
      const motion = byId(id).exact({ ...parameters, position })
      for (const t of [0, 5e-324, 1e-9, 0.1, 10, 1e6]) {
        const { s, v } = at(motion, t)
        const where = JSON.stringify({ ...parameters, position, t })
        expect(Number.isFinite(s) && Number.isFinite(v), where).toBe(true)
      }
    }
  })
})
