import { describe, expect, it } from 'vitest'
import { exactFall } from '../../src/physics/exact/fall.ts'

// gravity, mass, drag, position, speed, t; s; v. From Python's mpmath 1.3 with 80 digits, by another form of the
// solution: tanh, coth and tan of a time shifted to where v = 0 or ∞, and logarithms of cosh, sinh and cos.
const cases: [number[], number, number][] = [
  [[9.81, 1, 0.25, 0, 3, 2], 11.32369043001651009, 6.2557879465209621121],
  [[9.81, 1, 0.25, 0, 40, 2], 17.748302905138383724, 6.2815956971253922279],
  [[9.81, 1, 0.25, 0, -20, 0.3], -3.3956042812541176785, -6.4170449188962641192],
  [[9.81, 1, 0.25, 0, -20, 4], 12.384569007984474335, 6.263611628114906597],
  [[9.81, 1, 1e-12, 0, 5, 3], 59.144999998796458563, 34.429999998617426592],
  [[9.81, 1, 1e-12, 0, -50, 3], -105.85499999251490409, -20.569999996048373608],
  [[9.81, 1, 0.25, 0, -20, 1e-9], -1.9999999945095001429e-8, -19.999999890190000549],
  [[9.81, 1e-3, 2, 0, 1e6, 1e-8], 0.0015222612188618906014, 47619.047619081950335],
  [[9.81, 1, 0.25, 0, 1, 1e5], 626416.21037647477045, 6.2641839053463302667],
  [[0, 1, 0.25, 0, -7, 1000], -29.871769329143407404, -0.0039977155910908052541],
  [[1e-6, 1, 3, 0, -1e6, 2e3], -6.6833315840654378986, 0.00055175092799309856795],
]

// A dozen operations and three library functions, an ulp each, with their conditions near 1.
const ROUNDING = 16 * Number.EPSILON

function fall(values: readonly number[]) {
  const [gravity, mass, drag, position, speed] = values as [number, number, number, number, number]
  return exactFall({ gravity, mass, drag, position, speed })
}

describe('exactFall', () => {
  it.each(cases)('%j', (values, s, v) => {
    const state = fall(values)(values[5]!, { s: 0, v: 0 })
    expect(Math.abs(state.s / s - 1)).toBeLessThanOrEqual(ROUNDING)
    expect(Math.abs(state.v / v - 1)).toBeLessThanOrEqual(ROUNDING)
  })

  it.each([3, 0, -50])(
    'is the parabola without drag, and with the least there is (v₀ = %f)',
    (v0) => {
      const s = 2 + v0 * 3 + 4.5 * 9.81
      const v = v0 + 9.81 * 3
      for (const drag of [0, 5e-324, 1e-300, 1e-25]) {
        const state = fall([9.81, 1, drag, 2, v0])(3, { s: 0, v: 0 })
        expect(Math.abs(state.s - s)).toBeLessThanOrEqual(ROUNDING * 200)
        expect(Math.abs(state.v - v)).toBeLessThanOrEqual(ROUNDING * 50)
      }
    },
  )

  it('keeps the terminal speed', () => {
    const motion = fall([9, 1, 1, 0, 3])
    for (const t of [1e-9, 1, 30, 1e9])
      expect(motion(t, { s: 0, v: 0 })).toEqual({ s: 3 * t, v: 3 })
  })

  it('does not jump where cosh and sinh give way to eˣ', () => {
    // w = 1/s, so that they do at 20 s. Between the two times the ball falls 1e-6 m at 1 m/s.
    const motion = fall([1, 1, 1, 0, 5])
    const before = motion(20 - 5e-7, { s: 0, v: 0 })
    const after = motion(20 + 5e-7, { s: 0, v: 0 })
    expect(Math.abs(after.s - before.s - 1e-6)).toBeLessThanOrEqual(ROUNDING * 20)
  })

  it('is finite for whatever is in range', () => {
    for (const gravity of [0, 5e-324, 1e6])
      for (const mass of [1e-9, 1e9])
        for (const drag of [0, 5e-324, 1e-9, 1e6])
          for (const speed of [0, 5e-324, -5e-324, 1e9, -1e9])
            for (const t of [0, 5e-324, 1e-9, 1, 1e6]) {
              const { s, v } = fall([gravity, mass, drag, 1, speed])(t, { s: 0, v: 0 })
              expect(Number.isFinite(s) && Number.isFinite(v)).toBe(true)
            }
  })
})
