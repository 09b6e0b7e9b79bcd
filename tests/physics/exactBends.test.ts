/** The exact motion on 1 000 random bends, from rest, against itself by other steps and against the energy integral. */
import { afterEach, describe, expect, it, vi } from 'vitest'
import { scenes } from '../../src/physics/index.ts'
import type { Parameters, Scene, State } from '../../src/physics/index.ts'
import { Random } from '../../src/physics/random.ts'
import { samples } from '../samples.ts'
import { relative } from './truth.ts'

const random = new Random(20)
const uniform = (from: number, to: number) => from + ((to - from) * random.next()) / 2 ** 32
const pick = <T>(values: readonly T[]): T => values[random.next() % values.length]!

interface Bend {
  scene: Scene
  parameters: Parameters
  /** √(R/g), the time in which the law turns by about a radian [s]. */
  unit: number
}

/** From rest on a bend: at the angles whose series have gaps, and at others. */
function draw(i: number): Bend {
  const id = i % 2 ? 'run-out' : 'half-pipe'
  const scene = scenes.find((each) => each.id === id)!
  const degrees = i % 4 < 2 ? 15 * (1 + (random.next() % 6)) : uniform(1, 90)
  const radius = 10 ** uniform(-1, 0.8)
  const mu = pick([0, 0.05, 0.1, 0.2, uniform(0, 0.5)])
  const length = pick([0, 1, uniform(0, 5)])
  const [side, angle] = [pick([1, -1]), Math.min(degrees, 89.999) * (Math.PI / 180)]
  // On the run-out at the top of the bend, whose slope is that angle, or somewhere below it.
  const position =
    id === 'half-pipe' ? side * angle * radius : length + pick([0, 0, 0.3, 0.7]) * angle * radius
  const track = id === 'half-pipe' ? { radius } : { angle: degrees, length, bendRadius: radius }
  const common = { gravity: 9.81, mass: 1, muStatic: mu, muKinetic: mu, position, speed: 0 }
  return { scene, parameters: { ...track, ...common }, unit: Math.sqrt(radius / 9.81) }
}

const bends = Array.from({ length: samples(1000) }, (_, i) => draw(i))
const state = (): State => ({ s: NaN, v: NaN })

describe('the exact motion on random bends', () => {
  it('is the same by shorter steps', () => {
    for (const { scene, parameters, unit } of bends) {
      const motion = scene.exact(parameters)
      let here: State = { s: parameters['position']!, v: 0 }
      // A series is stepped over 0.1 to 0.3 units. A motion that starts again has a series of its own.
      const h = unit / 20
      for (let n = 1; n <= 100; n++) {
        here = scene.exact({ ...parameters, position: here.s, speed: here.v })(h, state())
        const { s, v } = motion(n * h, state())
        const where = JSON.stringify({ id: scene.id, ...parameters, n })
        // Each start rounds s and v, 100 times at most, by 1e-16 of up to 10 m on bends of 0.1 m and more, which turns
        // the slope by 1e-14 at most, and this lasts 5 units: 1e-12 would take all of them to one side.
        expect(relative(here.s - s, s), where).toBeLessThanOrEqual(1e-12)
        expect(relative(here.v - v, v), where).toBeLessThanOrEqual(1e-12)
      }
    }
  })

  it('has the kinetic energy of the energy integral up to the first stop', () => {
    let checked = 0
    for (const { scene, parameters, unit } of bends) {
      const motion = scene.exact(parameters)
      for (let n = 1; n <= 40; n++) {
        const { s, v } = motion((n * unit) / 8, state())
        if (v === 0 || Math.sign(v) !== Math.sign(motion(unit / 16, state()).v)) break
        if (scene.place(parameters, s).curvature === 0) break
        const expected = kineticEnergy(scene, parameters, s, Math.sign(v))
        checked++
        // Both are sums of a few terms of up to g R and more, rounded to an ulp each; an ulp of s is work, too.
        const { radius, bendRadius } = parameters
        const size = 9.81 * ((radius ?? bendRadius)! + Math.abs(s))
        const where = JSON.stringify({ id: scene.id, ...parameters, n })
        expect(Math.abs(v * v - 2 * expected), where).toBeLessThanOrEqual(64 * 2 ** -53 * size)
      }
    }
    expect(checked).toBeGreaterThan(samples(5000))
  })

  it('without friction turns all of the height into speed, on the flat too', () => {
    for (const { scene, parameters, unit } of bends) {
      if (parameters['muKinetic'] !== 0) continue
      const { s, v } = scene.exact(parameters)(10 * unit, state())
      const fall =
        scene.potential(parameters, parameters['position']!) - scene.potential(parameters, s)
      const size = 9.81 * (1 + Math.abs(s))
      expect(Math.abs(v * v - 2 * fall)).toBeLessThanOrEqual(256 * 2 ** -53 * size)
    }
  })
})

/**
 * Kinetic energy per mass at s of a block that started from rest on the same arc [J/kg]:
 * dK/dφ = 2mK − (g/κ)(sin φ − m cos φ), with m = ±μ, has K = C e^{2mφ} + (g/κ)(A cos φ + B sin φ).
 */
function kineticEnergy(scene: Scene, parameters: Parameters, s: number, slip: number): number {
  const { position, gravity, muKinetic } = parameters
  const { slope, curvature } = scene.place(parameters, s)
  const start = slope + curvature * (s - position!)
  const m = slip * muKinetic!
  const A = (1 - 2 * m * m) / (1 + 4 * m * m)
  const B = (3 * m) / (1 + 4 * m * m)
  const F = (angle: number) => A * Math.cos(angle) + B * Math.sin(angle)
  return (gravity! / curvature) * (F(slope) - F(start) * Math.exp(2 * m * (slope - start)))
}

describe('a step that is too long for its series', () => {
  afterEach(() => {
    vi.restoreAllMocks()
  })

  const pipe = scenes.find(({ id }) => id === 'half-pipe')! as Scene
  const parameters = { radius: 2, gravity: 9.81, mass: 1, muStatic: 0, muKinetic: 0 }
  const from = (position: number, speed: number) =>
    pipe.exact({ ...parameters, position, speed })(0.4, state())

  it('is refused, not returned', () => {
    const known = [from(1.6, 0), from(-0.5, 2)]
    for (const { s, v } of known) expect(Number.isFinite(s + v)).toBe(true)
    // The length of a step is a power; without friction, no other exponential is taken of anything but 0.
    const { exp } = Math
    vi.spyOn(Math, 'exp').mockImplementation((x) => (x === 0 ? 1 : 3 * exp(x)))
    for (const refused of [from(1.6, 0), from(-0.5, 2)]) expect(refused).toEqual({ s: NaN, v: NaN })
  })
})
