import { describe, expect, it } from 'vitest'
import { exactMotion, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { last, newScenes, relative } from './truth.ts'

// Rounding alone: an ulp of the angle ωt, which reaches 200 rad, is 3e-14 of a swing.
const ROUNDING = 1e-13

describe.each(newScenes)('$name', (each) => {
  const { experiment, duration, s, v, outcome } = each

  it('the exact motion ends in the true state', () => {
    const end = exactMotion(experiment)(duration, { s: 0, v: 0 })
    expect(relative(end.s - s, s)).toBeLessThanOrEqual(ROUNDING)
    expect(relative(end.v - v, v)).toBeLessThanOrEqual(ROUNDING)
  })

  it('rk8 in steps of 1/2000 s ends there too, with the same outcome at the same time', () => {
    const run = simulate({ ...experiment, ...fine })
    expect(run.outcome.kind).toBe(outcome)
    expect(relative(last(run.s) - s, s)).toBeLessThanOrEqual(1e-11)
    expect(relative(last(run.v) - v, v)).toBeLessThanOrEqual(1e-11)
    if (each.time !== undefined)
      expect(Math.abs(run.outcome.time - each.time)).toBeLessThanOrEqual(1e-12)
  })
})

const fine = { integrator: 'rk8', timestep: { kind: 'substeps', step: 1 / 2000 } } as const

describe.each(newScenes.filter(({ releases }) => releases.length > 0))(
  'stick and slip, $name',
  ({ experiment, duration, releases }) => {
    const { beltSpeed = 0, stiffness = 0, muStatic = 0, muKinetic = 0 } = experiment.parameters!
    const { gravity = 0, mass = 1 } = experiment.parameters!
    const motion = exactMotion(experiment)
    const at = (t: number) => motion(t, { s: 0, v: 0 })

    it('the spring tears the block off when it does in truth', () => {
      for (const release of releases.filter((t) => t < duration)) {
        expect(at(release * (1 - 1e-12)).v).toBe(beltSpeed)
        expect(at(release + 1e-6).v).not.toBe(beltSpeed)
      }
    })

    it('a cycle lasts as long as the closed form says, and swings as far', () => {
      const omega = Math.sqrt(stiffness / mass)
      const pull = ((muStatic - muKinetic) * gravity) / (omega * Math.abs(beltSpeed))
      const period = (2 * (Math.PI - Math.atan(pull) + pull)) / omega
      const [first, second] = releases as [number, number]
      expect(second - first).toBeCloseTo(period, 12)
      const run = simulate({ ...experiment, ...fine, duration: first + 2 * period })
      const swing = run.s.filter((_, row) => run.time[row]! > first)
      // About where the spring balances kinetic friction, by its speed and its distance at the release.
      const centre = (Math.sign(beltSpeed) * muKinetic * gravity) / omega ** 2
      const amplitude = Math.hypot(
        beltSpeed / omega,
        ((muStatic - muKinetic) * gravity) / omega ** 2,
      )
      // Between two frames a turning point is missed by up to ½ ω² A (dt/2)².
      const missed = 0.5 * omega ** 2 * amplitude * (1 / 120) ** 2
      const reach = Math.max(...swing.map((s) => Math.abs(s - centre)))
      expect(reach).toBeGreaterThanOrEqual(amplitude - missed)
      expect(reach).toBeLessThanOrEqual(amplitude + 1e-12)
    })

    it('a block that sticks has the belt’s speed to the bit, after ten thousand cycles too', () => {
      const run = simulate({ ...experiment, ...fine, frames: { kind: 'steady', fps: 200 } })
      const rides = run.v.filter((v) => v === beltSpeed)
      expect(rides.length).toBeGreaterThan(0)
      // A frame that does not begin or end with the slip is wholly slid or wholly ridden.
      for (let row = 1; row <= run.frames; row++) {
        const { v } = at(run.time[row]!)
        if (v === beltSpeed && at(run.time[row]! - 1e-6).v === beltSpeed)
          expect(run.v[row]).toBe(beltSpeed)
      }
    })
  },
)

describe('a belt', () => {
  const belt: Experiment = { scene: 'belt', duration: 6 }

  it('gives the energy that friction takes: the residual of a fine run is rounding', () => {
    const run = simulate({ ...belt, ...fine })
    const row = run.frames
    const energy = (i: number) => 0.5 * run.v[i]! ** 2 + 20 * run.s[i]! ** 2
    const residual = energy(row) + run.heat[row]! - run.work[row]! - energy(0)
    expect(run.work[row]).toBeGreaterThan(1)
    expect(Math.abs(residual)).toBeLessThan(1e-10)
  })

  it('under naive friction never carries the block: it trembles about the belt’s speed', () => {
    const run = simulate({
      ...{ ...belt, parameters: { speed: 0.4 }, stopping: 'naive', duration: 1 },
      integrator: 'semi-implicit-euler',
    })
    const beyond = run.v.map((v) => Math.sign(v - 0.4))
    const changes = beyond.filter((sign, row) => row > 0 && sign !== beyond[row - 1]).length
    // A cycle has two, and lasts about a second.
    expect(changes).toBeGreaterThan(5)
  })

  it('that stands still is a spring on the flat', () => {
    const parameters = { stiffness: 40, muStatic: 0.5, muKinetic: 0.3, position: 1, speed: 0.3 }
    const still = simulate({
      scene: 'belt',
      parameters: { ...parameters, beltSpeed: 0 },
      duration: 4,
    })
    const spring = simulate({
      scene: 'spring',
      parameters: { ...parameters, angle: 0 },
      duration: 4,
    })
    expect(still.s).toEqual(spring.s)
    expect(still.outcome).toEqual(spring.outcome)
  })

  it('carries a block that no spring holds for ever', () => {
    const run = simulate({ scene: 'belt', parameters: { stiffness: 0 }, duration: 10 })
    expect(last(run.v)).toBe(0.4)
    // It slips until it has the belt’s speed: u²/(2 μk g) less far than the belt.
    expect(last(run.s)).toBeCloseTo(0.4 * 10 - 0.16 / (2 * 0.3 * 9.81), 12)
  })
})

describe('a crest', () => {
  const frictionless = { crestRadius: 3, muStatic: 0, muKinetic: 0 }
  /** From its top, of speed v₀: v² = v₀² + 2gR(1 − cos θ), and press is 0 where v² = gR cos θ. */
  const fromTop: Experiment = {
    scene: 'crest',
    parameters: { ...frictionless, angle: 60, position: Math.PI, speed: 1 },
    duration: 4,
  }
  const cos = (1 / (9.81 * 3) + 2) / 3

  it.each([5, 10, 60, 144, 1000])('at %d fps a block takes off where press is 0', (fps) => {
    const run = simulate({ ...fromTop, integrator: 'rk8', frames: { kind: 'steady', fps } })
    expect(run.outcome.kind).toBe('left-the-track')
    // s = R(α + θ). A step of 0.2 s is a third of the time in which the law turns by a radian: (1/3)⁹/9! of it is its error.
    expect(Math.abs(last(run.s) - Math.PI - 3 * Math.acos(cos))).toBeLessThan(1e-9)
    expect(Math.abs(last(run.v) - Math.sqrt(9.81 * 3 * cos))).toBeLessThan(1e-9)
    const { outcome } = simulate({ ...fromTop, ...fine })
    expect(Math.abs(run.outcome.time - outcome.time)).toBeLessThan(1e-8)
  })

  it('too fast at its foot is left there, and exactly fast enough is not', () => {
    const tie = Math.sqrt(9.81 * 3 * Math.cos(Math.PI / 9))
    // It loses a millionth of a millionth of its energy on the last nanometre.
    const foot = (factor: number) =>
      simulate({
        scene: 'crest',
        parameters: { ...frictionless, angle: 20, position: -1e-9, speed: factor * tie },
        duration: 1,
      })
    expect(foot(1 + 1e-6).outcome.kind).toBe('left-the-track')
    expect(last(foot(1 + 1e-6).s)).toBe(0)
    expect(last(foot(1 - 1e-6).s)).toBeGreaterThan(0.5)
  })

  it('clamped and naive notice only at the end of a step: late, or not at all', () => {
    const located = simulate(fromTop)
    for (const stopping of ['clamped', 'naive'] as const) {
      const run = simulate({ ...fromTop, stopping, frames: { kind: 'steady', fps: 10 } })
      expect(last(run.s)).toBeGreaterThan(last(located.s) + 0.01)
    }
  })
})
