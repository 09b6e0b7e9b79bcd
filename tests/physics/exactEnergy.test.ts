import { describe, expect, it } from 'vitest'
import type { ExactMotion } from '../../src/physics/index.ts'
import { Random } from '../../src/physics/random.ts'
import { at, bare, breaks, byId, halfPipe, integral, ramp, runOut } from './exactly.ts'

describe('what changes the law', () => {
  const cases: [string, ExactMotion, number, number[]][] = [
    ['run-out', runOut({ muKinetic: 0.2, muStatic: 0.3, speed: -2 }), 4, [4, 4 + Math.PI / 4]],
    ['half-pipe', halfPipe({ muKinetic: 0.05, muStatic: 0.3, position: 3 }), 10, []],
    ['ramp', ramp({ muKinetic: 0.2, speed: -5 }), 3, []],
  ]
  it.each(cases)('leaves no gap in s and v: %s', (_, motion, duration, joints) => {
    const instants = breaks(motion, duration, joints)
    expect(instants.length).toBeGreaterThan(0)
    for (const t of instants) {
      const before = at(motion, t * (1 - 2 * Number.EPSILON))
      const after = at(motion, t)
      // Some ulps of time, at accelerations and speeds up to 20, and some of the state.
      expect(Math.abs(after.s - before.s)).toBeLessThanOrEqual(1e-13)
      expect(Math.abs(after.v - before.v)).toBeLessThanOrEqual(1e-13)
    }
  })
})

describe('energy and the heat of friction', () => {
  const random = new Random(5)
  const uniform = (from: number, to: number) => from + ((to - from) * random.next()) / 2 ** 32
  const cases = Array.from({ length: 12 }, (_, i) => ({
    id: i % 2 ? 'run-out' : 'half-pipe',
    ...bare,
    angle: uniform(5, 85),
    length: uniform(0, 3),
    bendRadius: uniform(0.5, 3),
    radius: uniform(1, 3),
    muStatic: uniform(0, 0.5),
    muKinetic: uniform(0, 0.5),
    position: uniform(-1, 1),
    speed: uniform(-4, 4),
  }))
  it.each(cases)('add up: $id, μ $muKinetic, α $angle', ({ id, ...parameters }) => {
    const scene = byId(id)
    const { track } = scene.law(parameters)
    const motion = scene.exact(parameters)
    const energy = (t: number) => {
      const { s, v } = at(motion, t)
      return scene.potential(parameters, s) + 0.5 * v * v
    }
    const power = (t: number) => {
      const { s, v } = at(motion, t)
      const { slope, curvature } = scene.place(parameters, s)
      const press = parameters.gravity * Math.cos(slope) + curvature * v * v
      return parameters.muKinetic * press * Math.abs(v)
    }
    let heat = 0
    const joints = track.slice(1).map(({ from }) => from)
    const ends = [0, ...breaks(motion, 3, joints), 3]
    for (let i = 1; i < ends.length; i++) heat += integral(power, ends[i - 1]!, ends[i]!)
    if (Math.abs(at(motion, 3).s) < track.at(-1)!.to)
      // Gauss: (6 ms · 10/s)⁶/2016000 of up to 500 J; the rest is rounding of 1500 terms.
      expect(Math.abs(energy(3) + heat - energy(0))).toBeLessThanOrEqual(1e-11)
  })
})
