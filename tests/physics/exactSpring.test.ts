import { describe, expect, it } from 'vitest'
import { exactSpring } from '../../src/physics/exact/spring.ts'
import { exactTrack } from '../../src/physics/exact/track.ts'
import { straight } from '../../src/physics/track.ts'

// angle, stiffness, muStatic, muKinetic, gravity, mass, position, speed, t; s; v. From Python's mpmath 1.3 with 80
// digits, one half-swing after the other: c + A cos(ωt + φ) about the balance point c of each slip direction.
const cases: [number[], number, number][] = [
  [[30, 40, 0.3, 0.2, 9.81, 1, 0, 0, 3], 0.16029290788874657216, 0],
  [[30, 40, 0.05, 0.02, 9.81, 1, 1.5, 2, 20], 1.0077303088218040389, -3.8309637864280432187],
  [[50, 1e-9, 0.3, 0.2, 9.81, 1, 1, -3, 4], 42.331489144986181527, 22.877208327438760434],
  [[20, 1e9, 0.001, 5e-4, 9.81, 1, 0.01, 100, 1], 0.0072970691897748693692, 238.22429915745462526],
  [[0, 4, 0.6, 0.4, 10, 1, 3.3, 0, 30], -1.2999999999999997113, 0],
  [[35, 300, 0.2, 0, 9.81, 2, 0.5, -1, 12.5], -0.3305476061392008569, -3.5726903941006365905],
  [[10, 25, 0.25, 0.1, 9.81, 1, -2, 0.5, 100], 0.0070183511794700554747, 0],
]

function named(values: readonly number[]) {
  const [angle, stiffness, muStatic, muKinetic, gravity, mass, position, speed] = values as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ]
  return { angle, stiffness, muStatic, muKinetic, gravity, mass, position, speed }
}

describe('exactSpring', () => {
  it.each(cases)('%j', (values, s, v) => {
    const parameters = named(values)
    const { stiffness, mass, position, speed } = parameters
    const omega = Math.sqrt(stiffness / mass)
    const t = values[8]!
    const state = exactSpring(parameters)(t, { s: 0, v: 0 })
    // The angle ωt is off by an ulp of itself for its product, for ω and for π/ω: so much of a swing, or of a slide.
    const size = Math.max(Math.abs(s), Math.min(Math.abs(position) + Math.abs(speed) / omega, 100))
    const rounding = 4 * Number.EPSILON * (4 + omega * t)
    expect(Math.abs(state.s - s)).toBeLessThanOrEqual(rounding * size)
    if (v === 0) expect(state.v).toBe(0)
    else
      expect(Math.abs(state.v - v)).toBeLessThanOrEqual(
        rounding * Math.max(Math.abs(v), omega * size),
      )
  })

  it('tends to the ramp as the spring gets weak', () => {
    const values = [25, 0, 0.3, 0.2, 9.81, 1, 0.5, -4]
    const ramp = exactTrack([straight(25)], named(values))
    for (const stiffness of [0, 5e-324, 1e-300, 1e-100, 1e-18, 1e-12, 1e-9]) {
      const spring = exactSpring({ ...named(values), stiffness })
      for (const t of [1e-9, 0.1, 0.5, 1, 10]) {
        const bare = ramp(t, { s: 0, v: 0 })
        const { s, v } = spring(t, { s: 0, v: 0 })
        // The spring's pull is below k · 150 m in all of the 10 s; the rest is rounding.
        const pull = 150 * stiffness
        expect(Math.abs(s - bare.s)).toBeLessThanOrEqual(0.5 * pull * t * t + 1e-13)
        expect(Math.abs(v - bare.v)).toBeLessThanOrEqual(pull * t + 1e-14)
      }
    }
  })

  it('swings for ever without friction, and any time costs the same', () => {
    // ω = 2/s: s = cos 2t, v = −2 sin 2t. At 1e9 s an ulp of the angle is 2e-7.
    const spring = exactSpring(named([0, 4, 0, 0, 10, 1, 1, 0]))
    for (const t of [1, 1000, 1e6, 1e9]) {
      const { s, v } = spring(t, { s: 0, v: 0 })
      const rounding = 2 * Number.EPSILON * (2 + 2 * t)
      expect(Math.abs(s - Math.cos(2 * t))).toBeLessThanOrEqual(rounding)
      expect(Math.abs(v + 2 * Math.sin(2 * t))).toBeLessThanOrEqual(2 * rounding)
    }
  })

  it('with static friction alone is held at the first stop that lets it, or never', () => {
    // The spring pulls with 4 s, friction holds up to 2: from 0.4 m it stays, from 0.6 m it swings for ever.
    expect(exactSpring(named([0, 4, 0.2, 0, 10, 1, 0.4, 0]))(1e6, { s: 0, v: 0 })).toEqual({
      s: 0.4,
      v: 0,
    })
    const { s } = exactSpring(named([0, 4, 0.2, 0, 10, 1, 0.6, 0]))(1000 * Math.PI, { s: 0, v: 0 })
    expect(s).toBeCloseTo(0.6, 10)
  })

  it('falls short by 2d a half-swing, and rests within the dead zone', () => {
    // d = 0.1 · 10/4 = 0.25 m: 1.4, −0.9, 0.4, and there the spring pulls with 1.6 against 2.
    const spring = exactSpring(named([0, 4, 0.2, 0.1, 10, 1, 1.4, 0]))
    const swing = Math.PI / 2
    for (const [n, s] of [1.4, -0.9, 0.4, 0.4].entries())
      expect(spring(n * swing, { s: 0, v: 0 }).s).toBeCloseTo(s, 14)
    expect(spring(2.01 * swing, { s: 0, v: 0 }).v).toBe(0)
  })

  it('rests where its pull ties with static friction, at the start or after some half-swings', () => {
    for (const angle of [0, 20])
      for (const muStatic of [0.05, 0.1, 0.3, 0.7])
        for (const stiffness of [3, 7, 11, 40])
          for (const gravity of [9.81, 10])
            for (let swings = 0; swings < 8; swings++) {
              const alpha = angle * (Math.PI / 180)
              const pull = gravity * Math.sin(alpha)
              const hold = muStatic * gravity * Math.cos(alpha)
              // Each half-swing takes 2f off the drive, f = hold/4.
              const position = (pull + hold + (swings * hold) / 2) / stiffness
              const motion = exactSpring(
                named([angle, stiffness, muStatic, muStatic / 4, gravity, 1, position, 0]),
              )
              const { s, v } = motion(1e3, { s: 0, v: 0 })
              const side = swings % 2 === 0 ? 1 : -1
              expect(v).toBe(0)
              expect(Math.abs(s - (pull + side * hold) / stiffness)).toBeLessThanOrEqual(1e-14)
            }
  })

  it('is finite for whatever is in range', () => {
    for (const stiffness of [5e-324, 1e-300, 1e12])
      for (const mu of [0, 1e-300, 1e6])
        for (const gravity of [0, 5e-324, 1e6])
          for (const mass of [1e-9, 1e9])
            for (const speed of [0, 5e-324, -1e-200, 1e9])
              for (const position of [0, 5e-324, -1e9])
                for (const t of [0, 5e-324, 1, 1e6]) {
                  const values = [30, stiffness, mu, mu, gravity, mass, position, speed]
                  const { s, v } = exactSpring(named(values))(t, { s: 0, v: 0 })
                  expect(Number.isFinite(s) && Number.isFinite(v)).toBe(true)
                }
  })
})
