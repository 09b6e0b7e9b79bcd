import { describe, expect, it } from 'vitest'
import { exact, exactMotion, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { measured, published } from './measured.ts'
import { hardCase, last, secondOrder } from './support.ts'

const controlled = ['velocity-verlet', 'rk4', 'rk8'] as const
const toTolerance = { timestep: { kind: 'tolerance', tolerance: 1e-9 } } as const
const steady = (fps: number) => ({ frames: { kind: 'steady', fps } }) as const
const g = 9.81

describe('23 stick and slip', () => {
  const omega = Math.sqrt(40)
  const [most, kinetic, u] = [(0.5 * g) / 40, (0.3 * g) / 40, 0.5]
  const slips = (2 * (Math.PI - Math.atan((omega * (most - kinetic)) / u))) / omega
  const rides = (2 * (most - kinetic)) / u
  const period = slips + rides

  it('rides to the bit, and keeps time', () => {
    const { id: name, experiments } = hardCase('stick-and-slip')
    const [base] = experiments as [Experiment]
    const truth = exactMotion(base)
    const off = (experiment: Experiment) =>
      Math.abs(last(simulate(experiment).s) - exact(base, 20).s)
    for (const { id } of secondOrder) {
      // Up to the first release it rides whatever the method; later the methods' own errors shift the riding.
      const run = simulate({ ...base, integrator: id, ...steady(240) })
      const inside = run.v.filter((_, row) => run.time[row]! < most / u)
      expect(inside.length).toBeGreaterThan(50)
      for (const v of inside) measured(name, 'rides', [id], Math.abs(v - u), { atMost: 0 })
    }
    for (const integrator of controlled) {
      const run = simulate({ ...base, integrator, ...toTolerance })
      let ridden = 0
      for (let row = 0; row < run.v.length; row++) {
        // Well inside a ride, by the truth a frame before and after.
        const around = [-1, 0, 1].map((i) => truth(run.time[row]! + i / 60, { s: 0, v: 0 }).v)
        if (!around.every((v) => v === u)) continue
        ridden++
        measured(name, 'rides', [integrator], Math.abs(run.v[row]! - u), { atMost: 0 })
      }
      expect(ridden).toBeGreaterThan(100)
      measured(name, 'period', [integrator], off({ ...base, integrator, ...toTolerance }), {
        atMost: 20e-9,
      })
    }
    for (const { id } of secondOrder) {
      const clamped = { ...base, integrator: id, stopping: 'clamped' } as const
      measured(name, 'clamped', [id], off(clamped), { atLeast: 1e-4 })
      const naive = simulate({ ...base, integrator: id, stopping: 'naive' })
      const least = Math.min(...naive.v.subarray(60).map((v) => Math.abs(v - u)))
      measured(name, 'naive', [id], least, { above: 0 })
    }
  })

  it('has the period and the amplitude of the closed form after ten thousand cycles', () => {
    const { id: name, experiments } = hardCase('ten-thousand-cycles')
    const duration = samples(100) < 100 ? 1014 : 10140
    const run = simulate({ ...experiments[0]!, duration })
    // Where the block is in its last cycle shows by how much all of them were off: at its speed there.
    const { s, v } = exact(experiments[0]!, duration)
    expect(Math.abs(v)).toBeGreaterThan(0.1)
    const cycles = Math.floor(duration / period)
    const late = Math.abs(last(run.s) - s) / Math.abs(v)
    // A swing's phase is off by (ωΔt)⁹ at the most, and two events are found to a hundred roundings of some tenths of a second.
    const bound = (omega / 60) ** 9 / omega + 200 * Number.EPSILON
    measured(name, 'period', [], late / cycles, { atMost: bound })
    const swing = Math.sqrt((most - kinetic) ** 2 + (u / omega) ** 2)
    // Frames fall evenly on a cycle: so near the turn lies one of them.
    const gap = (20 * period) / run.frames
    const atMost = 0.5 * omega * omega * swing * gap * gap
    measured(name, 'top', [], Math.abs(run.s.reduce((a, b) => Math.max(a, b)) - kinetic - swing), {
      atMost,
    })
    measured(
      name,
      'bottom',
      [],
      Math.abs(run.s.reduce((a, b) => Math.min(a, b)) - kinetic + swing),
      { atMost },
    )
  })
})

describe('24 take-off', () => {
  it('beyond the top: one place, one instant, one speed', () => {
    const { id: name, experiments } = hardCase('take-off-beyond-the-top')
    const [base] = experiments as [Experiment]
    const cos = 2 / 3 + 9 / (3 * g * 3)
    const place = 3 * (Math.PI / 4 + Math.acos(cos))
    const speed = Math.sqrt(g * 3 * cos)
    const times: number[] = []
    for (const integrator of controlled) {
      for (const fps of [5, 10, 24, 60, 144, 240]) {
        const run = simulate({ ...base, integrator, ...steady(fps) })
        expect(run.outcome.kind).toBe('left-the-track')
        times.push(run.outcome.time)
        const words = [integrator, `${fps} fps`]
        measured(name, 'place', words, Math.abs(last(run.s) - place), { atMost: 1e-8 })
        measured(name, 'speed', words, Math.abs(last(run.v) - speed), { atMost: 1e-8 })
      }
    }
    const spread = Math.max(...times) - Math.min(...times)
    measured(name, 'time', [], spread, { atMost: 1e-8 / 4.5 })
    const time = times.at(-1)!
    for (const { id } of secondOrder)
      for (const stopping of ['clamped', 'naive'] as const) {
        const run = simulate({
          ...base,
          integrator: id,
          stopping,
          ...steady(10),
          timestep: { kind: 'variable' },
        })
        expect(run.outcome.kind).toBe('left-the-track')
        measured(name, 'clamped', [id, stopping], run.outcome.time - time, {
          atLeast: 1e-3,
          atMost: 0.1,
        })
      }
  })

  it('by a billionth: one leaves and one stays', () => {
    const { id: name, experiments } = hardCase('take-off-by-a-billionth')
    const [over, under] = experiments as [Experiment, Experiment]
    for (const { id } of secondOrder) {
      const leaves = simulate({ ...over, integrator: id })
      expect(leaves.outcome.kind).toBe('left-the-track')
      measured(name, 'over', [id], Math.abs(last(leaves.s)), { atMost: 0 })
      const stays = simulate({ ...under, integrator: id })
      measured(name, 'under', [id], stays.outcome.time, { atLeast: 0.7 })
      if (id === 'rk8') measured(name, 'rk8', [], stays.outcome.time, { atLeast: 3, atMost: 3 })
      if (id !== 'velocity-verlet') continue
      expect(stays.outcome.kind).toBe('left-the-track')
      measured(name, 'verlet', [], stays.outcome.time, { atLeast: 0.75, atMost: 0.77 })
    }
    const explicit = simulate({ ...under, integrator: 'explicit-euler' })
    expect(explicit.outcome.kind).toBe('left-the-track')
    measured(name, 'explicit', [], explicit.outcome.time, { atMost: 0.5 })
    const semi = simulate({ ...over, integrator: 'semi-implicit-euler' })
    expect(semi.outcome.kind).toBe('moving')
    measured(name, 'semi-implicit', [], semi.outcome.time, { atLeast: 3, atMost: 3 })
  })

  it('is missed where only frames are looked at', () => {
    const { id: name, experiments } = hardCase('take-off-missed')
    const [base] = experiments as [Experiment]
    const a = g * (Math.sin(Math.PI / 9) + 0.1 * Math.cos(Math.PI / 9))
    const time = (7 - Math.sqrt(49 - 4 * a)) / a
    for (const { id } of secondOrder) {
      for (const fps of [5, 10, 24, 60, 144, 240]) {
        const run = simulate({ ...base, integrator: id, ...steady(fps) })
        expect(run.outcome.kind).toBe('left-the-track')
        expect(last(run.s)).toBe(0)
        // 240 frames at the most, an ulp of 7 m/s each.
        measured(name, 'located', [id, `${fps} fps`], Math.abs(run.outcome.time - time), {
          atMost: 240 * 4 * Number.EPSILON,
        })
      }
      for (const stopping of ['clamped', 'naive'] as const) {
        const run = simulate({ ...base, integrator: id, stopping })
        expect(run.outcome.kind).toBe('left-the-track')
        measured(name, 'late', [id, stopping], run.outcome.time - time, { atLeast: 0.01 })
      }
    }
    for (const stopping of ['clamped', 'naive'] as const) {
      const run = simulate({ ...base, integrator: 'semi-implicit-euler', stopping })
      expect(run.outcome.kind).toBe('moving')
      measured(name, 'never', [stopping], run.outcome.time, { atLeast: 2, atMost: 2 })
    }
  })
})

published('crestAndBelt')
