import { describe, expect, it } from 'vitest'
import { mechanicalEnergy, trajectoryErrors } from '../../src/measure/index.ts'
import { exact, simulate, traceFrame } from '../../src/physics/index.ts'
import type { Experiment, IntegratorId } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { measured, published } from './measured.ts'
import { hardCase, largest, last, methods } from './support.ts'

const STEP = 1 / 60

/** The case's own run with each method that it shows; a case has room for eight. */
function runsOf(id: string): { id: IntegratorId; experiment: Experiment }[] {
  const { experiments } = hardCase(id)
  return experiments.map((experiment) => ({ id: experiment.integrator!, experiment }))
}

const among = (id: string, ids: readonly IntegratorId[]) =>
  runsOf(id).filter((each) => ids.includes(each.id))

const allBut = (ids: readonly IntegratorId[]) =>
  methods.map(({ id }) => id).filter((id) => !ids.includes(id))

/** The lowest and the highest energy over some rows, relative to the first of all. */
function band(energy: Float64Array, from: number, to?: number) {
  const part = energy.subarray(from, to)
  const [low, high] = part.reduce(
    ([low, high], value) => [Math.min(low, value), Math.max(high, value)] as const,
    [Infinity, -Infinity] as const,
  )
  return { low: low / energy[0]! - 1, high: high / energy[0]! - 1 }
}

describe('9 a half-pipe from 89°, for 10 000 s at 60 fps', () => {
  const name = 'pipe-from-89-degrees'
  // [s]
  const duration = samples(1000, 10_000)
  const frames = 60 * duration
  // ω of small swings is √(g/R) = 2.2/s.
  const omegaDt = Math.sqrt(9.81 / 2) * STEP

  // A symplectic method's energy is off by some (ωΔt)ᵖ of it, by as much after 10 000 s as after 100. Rounding walks by
  // some ulps times the root of the steps.
  it.each(among(name, ['semi-implicit-euler', 'velocity-verlet', 'yoshida4', 'implicit-midpoint']))(
    '$id stays in its energy band',
    ({ id, experiment }) => {
      const run = simulate({ ...experiment, duration })
      expect(run.outcome.kind).toBe('moving')
      expect(run.frames).toBe(frames)
      expect(run.unsolved).toBe(0)
      const energy = mechanicalEnergy(run)
      const { order } = methods.find((method) => method.id === id)!
      const first = band(energy, 0, 6000)
      const whole = band(energy, 0)
      measured(name, id, [id], Math.max(whole.high, -whole.low), { atMost: omegaDt ** order })
      const rounding = 4 * Number.EPSILON * Math.sqrt(frames) * 10
      const drift = Math.max(whole.high - first.high, first.low - whole.low)
      measured(name, 'drift', [id], drift, { atMost: rounding + 0.01 * (first.high - first.low) })
    },
  )

  it.each(among(name, ['rk4']))('$id loses energy, slowly and steadily', ({ experiment }) => {
    const run = simulate({ ...experiment, duration })
    expect(run.outcome.kind).toBe('moving')
    const energy = mechanicalEnergy(run)
    // In the last hundredth of the frames to that one.
    const highest = (to: number) => band(energy, to - frames / 100, to).high
    // On a harmonic swing (ωΔt)⁶/72 a step; these swings are wide and slower, which makes it less.
    const most = frames * (omegaDt ** 6 / 72)
    const loss = -highest(frames + 1)
    measured(name, 'rk4', ['rk4'], loss, { atLeast: most / 10, atMost: most })
    const half = -highest(frames / 2)
    expect(half / loss).toBeGreaterThan(0.45)
    expect(half / loss).toBeLessThan(0.55)
  })

  // The lip is 1.75 % of the energy away.
  it.each([
    { id: 'explicit-euler' as const, from: 1, to: 5 },
    { id: 'midpoint' as const, from: 1000, to: 2000 },
  ])('$id is thrown out', (each) => {
    const run = simulate(among(name, [each.id])[0]!.experiment)
    expect(run.outcome.kind).toBe('left-the-track')
    measured(name, each.id, [each.id], run.outcome.time, { atLeast: each.from, atMost: each.to })
    expect(Math.abs(last(run.s))).toBe((Math.PI / 2) * 2)
    expect(last(mechanicalEnergy(run)) / mechanicalEnergy(run)[0]! - 1).toBeGreaterThan(0.0175)
  })
})

/** The modulus by which a step of a method multiplies the growing part of a swing, by its matrix at that z = ωΔt. */
const growths: Partial<Record<IntegratorId, (z: number) => number>> = {
  'explicit-euler': (z) => Math.sqrt(1 + z * z),
  'semi-implicit-euler': (z) => fromTrace(2 - z * z),
  'velocity-verlet': (z) => fromTrace(2 - z * z),
  midpoint: (z) => Math.hypot(1 - z ** 2 / 2, z),
  rk4: (z) => Math.hypot(1 - z ** 2 / 2 + z ** 4 / 24, z - z ** 3 / 6),
  yoshida4: (z) => {
    const outer = 1 / (2 - Math.cbrt(2))
    const inner = -Math.cbrt(2) * outer
    const [a, b, c] = [outer, inner, outer].map((w) => verletMatrix(w * z))
    const product = times(times(a!, b!), c!)
    return fromTrace(product[0] + product[3])
  },
  'implicit-midpoint': () => 1,
}

type Matrix = readonly [number, number, number, number]

/** A Verlet step on (s, v/ω). */
const verletMatrix = (z: number): Matrix => [
  1 - z ** 2 / 2,
  z,
  -z * (1 - z ** 2 / 4),
  1 - z ** 2 / 2,
]

const times = (a: Matrix, b: Matrix): Matrix => [
  a[0] * b[0] + a[1] * b[2],
  a[0] * b[1] + a[1] * b[3],
  a[2] * b[0] + a[3] * b[2],
  a[2] * b[1] + a[3] * b[3],
]

/** The larger eigenvalue of a step that keeps areas. */
function fromTrace(trace: number): number {
  const half = Math.abs(trace) / 2
  return half <= 1 ? 1 : half + Math.sqrt(half * half - 1)
}

describe.each([
  { id: 'below-verlets-limit', z: 1.99 },
  { id: 'at-verlets-limit', z: 2 },
  { id: 'beyond-verlets-limit', z: 2.01 },
  { id: 'below-rk4s-limit', z: 2.82 },
  { id: 'beyond-rk4s-limit', z: 2.83 },
])('10 the spring at ωΔt = $z', ({ id: name, z }) => {
  const omega = z / STEP

  it.each(runsOf(name))('$id: bounded, or diverged when the theory says so', (each) => {
    const run = simulate(each.experiment)
    const growth = growths[each.id]!(z)
    if (growth > 1 + 1e-9) {
      expect(run.outcome.kind).toBe('diverged')
      // A run has diverged at 1000 times the fastest that it could be, ω · 1 m. Of the growing part there is some tenth to
      // some ten times at the start.
      const steps = Math.log(1000) / Math.log(growth)
      const give = Math.log(20) / Math.log(growth) + 1
      measured(name, 'diverged', [each.id], run.steps, {
        atLeast: Math.max(1, Math.ceil(steps - give)),
        atMost: Math.floor(steps + give),
      })
      expect(run.outcome.time).toBe(last(run.stateTime))
      expect(Math.abs(last(run.v))).toBeGreaterThan(1000 * omega)
      expect(largest(run.v.subarray(0, -1))).toBeLessThanOrEqual(1000 * omega)
    } else if (z === 2 && each.id === 'semi-implicit-euler') {
      // A double eigenvalue −1: two steps add 4 m, and 1000 m is reached in the end.
      const shares = run.s.subarray(1).map((s, row) => s / (2 * (row + 1) + 1))
      measured(name, 'linear', [each.id], largest(shares), { atMost: 1 })
      expect(run.outcome.kind).toBe('diverged')
    } else {
      expect(run.outcome.kind).toBe('moving')
      expect(run.frames).toBe(60_000)
      // Rounding grows evenly over 60 000 steps.
      const rounding = 1 + 60_000 * 4 * Number.EPSILON
      // Semi-implicit Euler keeps an ellipse with half-axis 1/√(1 − z²/4); the others never exceed the start.
      const axis = 1 / Math.sqrt(1 - (z * z) / 4)
      const isEllipse = each.id === 'semi-implicit-euler'
      measured(name, isEllipse ? 'ellipse' : 'bounded', [each.id], largest(run.s), {
        ...(isEllipse && { atLeast: 0.99 * axis }),
        atMost: (isEllipse ? axis : 1) * rounding,
      })
      // rk4 damps: stable is not accurate.
      if (each.id === 'rk4') expect(Math.abs(last(run.s))).toBeLessThan(1e-300)
      if (each.id === 'implicit-midpoint') expectEnergyKept(name, each.experiment)
    }
  })
})

/** Implicit midpoint keeps a quadratic energy exactly; each step is solved to two roundings, at ωΔt times as much. */
function expectEnergyKept(name: string, experiment: Experiment): void {
  const run = simulate(experiment)
  expect(run.unsolved).toBe(0)
  const { low, high } = band(mechanicalEnergy(run), 0)
  measured(name, 'energy', [experiment.integrator!], Math.max(high, -low), {
    atMost: run.steps * 8 * Number.EPSILON,
  })
}

describe('11 a stiffness of 1e9: ωΔt = 527', () => {
  const name = 'stiff-as-steel'

  it.each(among(name, ['implicit-midpoint']))(
    '$id keeps the energy to rounding',
    ({ id, experiment }) => {
      const run = simulate(experiment)
      expect(run.outcome.kind).toBe('moving')
      expect(run.frames).toBe(6000)
      expect(largest(run.s)).toBeLessThanOrEqual(1 + 6000 * 4 * Number.EPSILON)
      expectEnergyKept(name, experiment)
      // One secant through two points solves a linear equation; a third look sees that it has.
      measured(name, 'evaluations', [id], run.evaluations / run.steps, { atMost: 5 })
    },
  )

  it.each(among(name, allBut(['implicit-midpoint'])))(
    '$id has diverged within three frames, and says so',
    ({ id, experiment }) => {
      const run = simulate(experiment)
      expect(run.outcome.kind).toBe('diverged')
      measured(name, 'diverged', [id], run.frames, { atMost: 3 })
      expect(run.s.every(Number.isFinite)).toBe(true)
    },
  )
})

describe('12 twenty reversals in a frame', () => {
  const name = 'many-reversals'
  const omega = Math.sqrt(4000)
  // By what a harmonic swing's frequency is off, in (ωΔt)ᵖ: from each step matrix's expansion. Yoshida's by (1 + 2∛2 +
  // ∛4 …)/… is below 0.07. The Eulers' frequency is right to second order, and their positions off by ½ v Δt.
  const frequency: Partial<Record<IntegratorId, number>> = {
    'velocity-verlet': 1 / 24,
    midpoint: 1 / 6,
    rk4: 1 / 120,
    yoshida4: 0.07,
    'implicit-midpoint': 1 / 12,
  }

  it.each(among(name, allBut(['explicit-euler'])))('$id finds every one', ({ id, experiment }) => {
    const stops = traceFrame(experiment, 1)
      .flatMap(({ stretches }) => stretches)
      .filter(({ ends }) => ends === 'stop')
    // Every half swing ends with one: √4000/π of them in the first second.
    const turns = Math.floor(omega / Math.PI)
    measured(name, 'found', [id], stops.length, { atLeast: turns, atMost: turns })
    const run = simulate(experiment)
    const { order } = methods.find((method) => method.id === id)!
    // The swing's largest speed 0.1 m ω, and the phase after 4 s.
    const amplitude = 0.1
    const error = trajectoryErrors(run).largest
    const byPhase = (frequency[id] ?? 0) * (omega / 1000) ** order * omega * 4 * amplitude
    const byPlace = order === 1 ? 0.5 * (omega / 1000) * amplitude : 0
    measured(name, 'error', [id], error, {
      atLeast: (byPhase + byPlace) / 20,
      atMost: byPhase + byPlace,
    })
  })

  it.each(among(name, ['explicit-euler']))(
    '$id diverges: it gains (ωΔt)² a step',
    ({ id, experiment }) => {
      const run = simulate(experiment)
      expect(run.outcome.kind).toBe('diverged')
      // e^(½ ω² Δt t) reaches a thousand after 3.5 s.
      measured(name, id, [id], run.outcome.time, { above: 3 })
    },
  )

  it.each(runsOf('many-reversals-in-a-step'))(
    '$id, all in one step: wrong, but it ends',
    ({ id, experiment }) => {
      const name = 'many-reversals-in-a-step'
      const run = simulate(experiment)
      for (const column of [run.s, run.v, run.heat])
        expect(column.every(Number.isFinite)).toBe(true)
      const off = Math.abs(last(run.s) - exact(experiment, last(run.stateTime)).s)
      measured(name, 'wrong', [id], off, { above: 1e-3 })
      // A hundred jumps a step at the most, each found in a hundred tries at the most, of some evaluations.
      measured(name, 'ends', [id], run.evaluations / run.steps, { atMost: 100 * 100 * 4 })
    },
  )
})

published('oscillations', 'pipe-from-89-degrees')
