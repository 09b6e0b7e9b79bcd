/** The heat of one step, against the integral of what resists along the way, taken in a thousand parts. */
import { describe, expect, it } from 'vitest'
import { addHeat } from '../../src/physics/heat.ts'
import { lawOf } from '../../src/physics/law.ts'
import { Motion } from '../../src/physics/motion.ts'
import { straight } from '../../src/physics/track.ts'

interface Case {
  name: string
  curvature: number
  muKinetic: number
  drag: number
  stiffness: number
}

const mass = 1.7
const slope = 35

const cases: Case[] = [
  { name: 'friction in a hollow', curvature: 0.6, muKinetic: 0.3, drag: 0, stiffness: 0 },
  { name: 'friction on a crest', curvature: -0.3, muKinetic: 0.3, drag: 0, stiffness: 0 },
  { name: 'drag alone', curvature: 0, muKinetic: 0, drag: 0.4, stiffness: 0 },
  { name: 'drag and friction on a slope', curvature: 0, muKinetic: 0.3, drag: 0.4, stiffness: 0 },
  { name: 'drag and a spring', curvature: 0, muKinetic: 0.1, drag: 0.4, stiffness: 5 },
  { name: 'all of it', curvature: 0.6, muKinetic: 0.3, drag: 0.4, stiffness: 5 },
]

function lawFor({ curvature, muKinetic, drag, stiffness }: Case) {
  const track = [{ ...straight(slope), curvature }]
  const friction = { muStatic: muKinetic, muKinetic }
  return lawOf(track, {
    ...{ gravity: 9.81, mass, drag: drag * mass, stiffness: stiffness * mass },
    ...friction,
  })
}

/**
 * The speed at a distance h further on, and the heat up to there [J]: both by Runge and Kutta's method over the distance,
 * for K = ½v², in a thousand parts, whose own error is (h/1000)⁴.
 */
function truth(given: Case, s: number, v: number, h: number): { v: number; heat: number } {
  const { curvature, muKinetic, drag, stiffness } = given
  const slip = Math.sign(h)
  const resists = (at: number, K: number) => {
    const direction = (slope * Math.PI) / 180 - curvature * at
    return muKinetic * (9.81 * Math.cos(direction) + 2 * curvature * K) + 2 * drag * K
  }
  const gains = (at: number, K: number) => {
    const direction = (slope * Math.PI) / 180 - curvature * at
    return 9.81 * Math.sin(direction) - stiffness * at - slip * resists(at, K)
  }
  const parts = 1000
  const d = h / parts
  let K = 0.5 * v * v
  let heat = 0
  for (let i = 0; i < parts; i++) {
    const at = s + i * d
    const half = at + d / 2
    const two = K + (d / 2) * gains(at, K)
    const three = K + (d / 2) * gains(half, two)
    const four = K + d * gains(half, three)
    const sum = (of: typeof gains) =>
      (of(at, K) + 2 * of(half, two) + 2 * of(half, three) + of(at + d, four)) / 6
    heat += Math.abs(d) * sum(resists)
    const next = K + d * sum(gains)
    K = next
  }
  return { v: slip * Math.sqrt(2 * K), heat: mass * heat }
}

/** The heat of the steps that end at those distances from the first. */
function heatOf(given: Case, s: number, v: number, ...ends: number[]): number {
  const motion = new Motion(lawFor(given), s, v, true)
  for (const end of ends) {
    motion.begin()
    motion.s = s + end
    motion.v = truth(given, s, v, end).v
    addHeat(motion)
  }
  return motion.heat
}

describe.each(cases)('the heat of a step: $name', (given) => {
  const starts = [
    { s: 0.4, v: 4, h: 0.2 },
    { s: 0.4, v: -4, h: -0.2 },
    { s: -0.3, v: 2.5, h: 0.2 },
  ]

  it.each(starts)('is the integral along it, from $s m at $v m/s', ({ s, v, h }) => {
    const { heat } = truth(given, s, v, h)
    expect(heat).toBeGreaterThan(0.15)
    // Hermite's formula leaves R⁽⁸⁾ h⁹/(70 · 8! · 630), with derivatives of (2 (c/m + μκ))⁸ or ω of some 2/m: (0.4)⁹/1e9.
    expect(Math.abs(heatOf(given, s, v, h) / heat - 1)).toBeLessThanOrEqual(1e-12)
  })

  it('is that of two steps of half of it, and the end of one is the start of the next', () => {
    for (const { s, v, h } of starts) {
      const whole = heatOf(given, s, v, h)
      expect(Math.abs(heatOf(given, s, v, h / 2, h) / whole - 1)).toBeLessThanOrEqual(1e-12)
    }
  })

  it('keeps to the mean of both ends where a step is so long that derivatives say nothing', () => {
    // In each case the force has changed altogether over 2.2 m. Any speed at the end will do.
    const [s, v, end, h] = [0.4, 2, 1, 2.2]
    const { curvature, muKinetic, drag } = given
    const resists = (at: number, speed: number) => {
      const direction = (slope * Math.PI) / 180 - curvature * at
      return muKinetic * (9.81 * Math.cos(direction) + curvature * speed ** 2) + drag * speed ** 2
    }
    const motion = new Motion(lawFor(given), s, v, true)
    motion.begin()
    motion.s = s + h
    motion.v = end
    addHeat(motion)
    const mean = (resists(s, v) + resists(s + h, end)) / 2
    expect(motion.heat / (mass * h * mean)).toBeCloseTo(1, 13)
  })
})

describe('the heat of longer and longer steps', () => {
  it('is off by the ninth power of their length, as in a method of eighth order', () => {
    const given = cases.at(-1)!
    const error = (h: number) => Math.abs(heatOf(given, 0.4, 4, h) - truth(given, 0.4, 4, h).heat)
    const ratios = [0.32, 0.4, 0.5].map((h) => Math.log2(error(h) / error(h / 2)))
    for (const order of ratios) expect(order).toBeGreaterThan(8.6)
    for (const order of ratios) expect(order).toBeLessThan(9.6)
  })

  it('after a turn, opposes the other way', () => {
    const given = cases[3]!
    const motion = new Motion(lawFor(given), 0.4, -1, true)
    motion.begin()
    motion.s = 0.3
    motion.v = truth(given, 0.4, -1, -0.02).v
    addHeat(motion)
    const before = motion.heat
    motion.s = 0.3
    motion.v = 1
    motion.slide(1)
    motion.begin()
    const end = truth(given, 0.3, 1, 0.2)
    motion.s = 0.5
    motion.v = end.v
    addHeat(motion)
    expect(Math.abs((motion.heat - before) / end.heat - 1)).toBeLessThanOrEqual(1e-12)
  })
})
