import { describe, expect, it } from 'vitest'
import { exactTrack } from '../../src/physics/exact/track.ts'
import { straight } from '../../src/physics/track.ts'
import { at, bare, breaks, halfPipe, integral, ramp, runOut } from './exactly.ts'

/** The pendulum by Jacobi's sn, from the arithmetic-geometric mean (Abramowitz & Stegun 16.4, 17.6). */
function pendulum(radius: number, gravity: number, position: number, t: number): number {
  const k = Math.sin(position / radius / 2)
  const a = [1]
  const c = [k]
  let b = Math.sqrt(1 - k * k)
  // It converges quadratically: the next c is c²/4.
  while (Math.abs(c.at(-1)!) > 1e-9) {
    const last = a.at(-1)!
    a.push((last + b) / 2)
    c.push((last - b) / 2)
    b = Math.sqrt(last * b)
  }
  const quarter = Math.PI / 2 / a.at(-1)!
  const u = quarter - ((Math.sqrt(gravity / radius) * t) % (4 * quarter))
  let phi = 2 ** (a.length - 1) * a.at(-1)! * u
  for (let n = a.length - 1; n > 0; n--)
    phi = (phi + Math.asin((c[n]! / a[n]!) * Math.sin(phi))) / 2
  return 2 * radius * Math.asin(k * Math.sin(phi))
}

describe('a half-pipe without friction', () => {
  it.each([1e-200, 1e-3, 1, 1.6, 3, (89 / 90) * Math.PI])(
    'is the pendulum, from %f m',
    (position) => {
      const motion = halfPipe({ position })
      for (const t of [0.01, 0.1, 1, 3.7, 10, 100, 1000]) {
        // The period is known to a few ulps, here and there, and the angle turns by as many for each radian.
        const rounding = 4 * Number.EPSILON * (4 + 2.5 * t)
        const error = at(motion, t).s - pendulum(2, 9.81, position, t)
        expect(Math.abs(error)).toBeLessThanOrEqual(rounding * position)
      }
    },
  )

  it('knows no time too late', () => {
    // Jacobi's sn with 50 digits, by Python's mpmath 1.3. An ulp of 1e6 s of motion at 5 m/s is 1e-9 m.
    const motion = halfPipe({ position: 3.1 })
    expect(Math.abs(at(motion, 1e5).s - 2.2242252935651642)).toBeLessThanOrEqual(1e-9)
    expect(Math.abs(at(motion, 1e6).s + 0.47308653055938606)).toBeLessThanOrEqual(1e-8)
  })

  it('comes back for ever if static friction lets go at the turning points', () => {
    // tan 30° < 0.6: it would stay at 1 m, not at 1.6 m, where the slope is 46°.
    const position = 1.6
    const free = halfPipe({ position })
    const held = halfPipe({ position, muStatic: 0.6 })
    for (const t of [1, 10, 1e5]) expect(at(held, t)).toEqual(at(free, t))
    expect(at(halfPipe({ position: 1, muStatic: 0.6 }), 1e5)).toEqual({ s: 1, v: 0 })
  })

  it('loses the block at the lip, and keeps the state that it had there', () => {
    const lip = Math.PI
    const gone = at(halfPipe({ speed: 10 }), 5)
    expect(gone.s).toBe(lip)
    // ½v² = ½v₀² − gR
    expect(Math.abs(gone.v - Math.sqrt(100 - 4 * 9.81))).toBeLessThanOrEqual(1e-14)
    expect(at(halfPipe({ speed: 10 }), 1e6)).toEqual(gone)
    expect(at(halfPipe({ speed: -10 }), 5)).toEqual({ s: -lip, v: -gone.v })
  })
})

describe('a half-pipe with friction', () => {
  // radius, gravity, muStatic, muKinetic, position, speed, t; s; v. Taylor's series of degree 40 with 40 digits in
  // Python's mpmath 1.3, turning points by its findroot.
  it.each([
    [2, 9.81, 0.0015, 0.001, 3, 0, 100, -0.4606062835294986668562, -4.900572299609909714717],
    [2, 9.81, 0.0015, 0.001, 3, 0, 1000, -6.357991928176029723768e-4, 0],
    [0.7, 20, 0.3, 0.05, -1, 0.5, 8, -0.1729176739075525676757, 0],
    [2, 9.81, 0, 1e-6, 3, 0, 300, 2.985756619890742715536, -0.488868952125347834003],
  ])(
    'agrees with 40 digits: R %f, g %f, μs %f, μk %f, from %f m at %f m/s, after %f s',
    (radius, gravity, muStatic, muKinetic, position, speed, t, s, v) => {
      const state = at(halfPipe({ radius, gravity, muStatic, muKinetic, position, speed }), t)
      // Some 2000 series round s and v, an ulp of 2e-16 each; that shifts the period, and so 660 rad of swinging: 1e-10
      // were they all to one side, and a few per cent of that by chance. Times of phases add nothing: 4e-13 s at 100 s
      // were they summed without their low parts, and four times that in s.
      expect(Math.abs(state.s - s)).toBeLessThanOrEqual(1e-13)
      expect(Math.abs(state.v - v)).toBeLessThanOrEqual(3e-12)
    },
  )

  it('swings less far every time, and rests where static friction holds it', () => {
    const motion = halfPipe({ position: 3, muStatic: 0.02, muKinetic: 0.01 })
    const stops = breaks(motion, 200, []).map((t) => Math.abs(at(motion, t).s))
    expect(stops.length).toBeGreaterThan(20)
    for (const [i, size] of stops.entries()) expect(size).toBeLessThan(stops[i - 1] ?? 3)
    const { s, v } = at(motion, 1e6)
    expect(v).toBe(0)
    expect(Math.tan(Math.abs(s) / 2)).toBeLessThanOrEqual(0.02)
  })
})

describe('a ramp', () => {
  it.each([1 - 1e-12, 1 + 1e-12])('with tan α = %f of μs decides so for an hour', (part) => {
    const muStatic = Math.tan(Math.PI / 6) / part
    const { s, v } = at(ramp({ muStatic, muKinetic: 0.2 }), 3600)
    const a = 9.81 * (0.5 - 0.2 * Math.sqrt(0.75))
    if (part < 1) expect({ s, v }).toEqual({ s: 0, v: 0 })
    else {
      expect(Math.abs(s / (0.5 * a * 3600 * 3600) - 1)).toBeLessThanOrEqual(4 * Number.EPSILON)
      expect(Math.abs(v / (a * 3600) - 1)).toBeLessThanOrEqual(4 * Number.EPSILON)
    }
  })

  it('takes static friction for no less than kinetic', () => {
    expect(at(ramp({ muStatic: 0.1, muKinetic: 0.6 }), 10)).toEqual({ s: 0, v: 0 })
  })

  it('keeps all digits of a fast and of a slow block', () => {
    for (const speed of [1e9, 1e-200]) {
      const motion = ramp({ speed, muKinetic: 1 })
      const a = 9.81 * (Math.sqrt(0.75) - 0.5)
      const { s, v } = at(motion, 1e12)
      expect(v).toBe(0)
      if (speed > 1)
        expect(Math.abs((s * 2 * a) / speed / speed - 1)).toBeLessThanOrEqual(8 * Number.EPSILON)
    }
  })
})

describe('a run-out', () => {
  it.each([0, 5e-324, 1e-300, 1e-17])('with next to no bend (%f°) is a flat', (angle) => {
    const motion = runOut({ angle, muKinetic: 0.5, muStatic: 0.5, speed: 8 })
    // v²/(2 μ g), beyond the joint at 4 m. The bend, where there is one, is shorter than an ulp.
    expect(Math.abs(at(motion, 3).s - 64 / 9.81)).toBeLessThanOrEqual(4e-15)
    expect(at(motion, 3).v).toBe(0)
  })

  it.each([1, -1])('enters the piece ahead from a joint (towards %f)', (slip) => {
    const end = 4 + (1.5 * Math.PI) / 6
    for (const position of [4, end]) {
      const { s, v } = at(runOut({ position, speed: slip }), 1e-6)
      const slope = position === 4 ? 0.5 : 0
      // A thousandth of a microsecond's worth of the slope's change is left.
      expect(Math.abs(s - position - slip * 1e-6)).toBeLessThanOrEqual(1e-11)
      expect(Math.abs(v - slip - 9.81 * slope * 1e-6)).toBeLessThanOrEqual(1e-11)
    }
  })

  it('sets off from the upper joint, and stays at the lower', () => {
    const end = 4 + 1.5 * (30 * (Math.PI / 180))
    expect(at(runOut({ position: 4 }), 1).v).toBeGreaterThan(0)
    expect(Math.abs(at(runOut({ position: end }), 1).v)).toBeLessThanOrEqual(1e-15)
    expect(at(runOut({ position: end, muStatic: 0.1 }), 1e6)).toEqual({ s: end, v: 0 })
  })

  it('stops where a straight ends', () => {
    // v² = 2 μ g d: 5² = 2 · 0.5 · 10 · 2.5.
    const flat = { ...straight(0), to: 2.5 }
    const rise = { ...straight(0), from: 2.5, slope: -0.1, sin: -Math.sin(0.1), cos: Math.cos(0.1) }
    const friction = { gravity: 10, muStatic: 0.5, muKinetic: 0.5 }
    const motion = exactTrack([flat, rise], { ...friction, position: 0, speed: 5 })
    expect(Math.abs(at(motion, 2).s - 2.5)).toBeLessThanOrEqual(Number.EPSILON * 2)
    expect(at(motion, 2).v).toBe(0)
  })

  it('without friction turns energy into speed, on the flat', () => {
    const drop = 4 * 0.5 + 1.5 * (1 - Math.sqrt(0.75))
    expect(Math.abs(at(runOut({}), 5).v - Math.sqrt(2 * 9.81 * drop))).toBeLessThanOrEqual(4e-15)
  })
})

describe('an arc that bends downwards', () => {
  // 20° up at s = 0, the top at 60/57.3 m, 20° down at the end.
  const angle = 20 * (Math.PI / 180)
  const arc = { at: 0, x: 0, y: 0, slope: -angle, sin: -Math.sin(angle), cos: Math.cos(angle) }
  const crest = [{ ...arc, from: 0, to: 6 * angle, curvature: -1 / 3 }]
  const over = (muKinetic: number, speed: number) =>
    exactTrack(crest, { ...bare, muStatic: muKinetic, muKinetic, speed })

  it('takes speed up to the top and gives it back', () => {
    const end = at(over(0, 2), 5)
    expect(end.s).toBe(6 * angle)
    expect(Math.abs(end.v - 2)).toBeLessThanOrEqual(1e-14)
    // At the same height before and after the top it is as fast, and as long before as after.
    const motion = over(0, 2)
    let [low, high] = [0, 5]
    while ((low + high) / 2 > low && (low + high) / 2 < high)
      if (at(motion, (low + high) / 2).s < 3 * angle) low = (low + high) / 2
      else high = (low + high) / 2
    for (const t of [0.1, 0.3, 0.5]) {
      const [before, after] = [at(motion, low - t), at(motion, low + t)]
      expect(Math.abs(before.s + after.s - 6 * angle)).toBeLessThanOrEqual(1e-13)
      expect(Math.abs(before.v - after.v)).toBeLessThanOrEqual(1e-13)
    }
  })

  it('keeps its energy but for friction, whose press is less by κ v²', () => {
    const motion = over(0.1, 3)
    const energy = (t: number) =>
      0.5 * at(motion, t).v ** 2 + 9.81 * 3 * Math.cos(at(motion, t).s / 3 - angle)
    const power = (t: number) => {
      const { s, v } = at(motion, t)
      return 0.1 * (9.81 * Math.cos(s / 3 - angle) - (v * v) / 3) * v
    }
    expect(at(motion, 0.6).s).toBeLessThan(6 * angle)
    expect(Math.abs(energy(0.6) + integral(power, 0, 0.6) - energy(0))).toBeLessThanOrEqual(1e-13)
  })
})

describe('an open end of a track', () => {
  const plank = [{ ...straight(30, 1), from: -1 }]
  const bare = { gravity: 9.81, muStatic: 0, muKinetic: 0 }
  const from = (position: number, speed = 0) => exactTrack(plank, { ...bare, position, speed })

  it('lets go a block put down on the upper one, which slides the length and is gone', () => {
    const gone = at(from(-1), 5)
    expect(gone.s).toBe(1)
    expect(Math.abs(gone.v - Math.sqrt(2 * 9.81 * 0.5 * 2))).toBeLessThanOrEqual(1e-15)
  })

  it('keeps the state of one put down on the lower one, or beyond either', () => {
    for (const position of [1, 1.5, -1.5])
      expect(at(from(position), 5)).toEqual({ s: position, v: 0 })
    expect(at(from(1.5, 2), 5)).toEqual({ s: 1.5, v: 2 })
  })
})

describe('a swing of a few of the smallest numbers', () => {
  it.each([1, 2, 3, 10, 50])('stays as small, from %i of them', (count) => {
    const position = count * 5e-324
    for (const muKinetic of [0, 1e-9, 0.1, 0.5])
      for (const gravity of [5e-324, 1e-300, 9.81, 1e6])
        for (const radius of [0.001, 0.5, 1, 2, 7, 1e6]) {
          const motion = halfPipe({ position, gravity, radius, muKinetic })
          for (const t of [0, 0.5, 1, 10, 100]) {
            const { s, v } = at(motion, t)
            // Every phase rounds to whole units of 5e-324, and there are some dozens of them.
            expect(Math.abs(s)).toBeLessThanOrEqual(position + 100 * 5e-324)
            expect(Number.isFinite(v)).toBe(true)
          }
        }
  })
})
