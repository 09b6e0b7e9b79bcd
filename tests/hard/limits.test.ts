import { describe, expect, it } from 'vitest'
import { exact, integrators, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'
import { measured, published } from './measured.ts'
import { firstOrder, hardCase, having, largest, last, secondOrder } from './support.ts'

const ids = integrators.map(({ id }) => id)
const HALF_ULP = Number.EPSILON / 2

describe('21 ties', () => {
  const { id: name, experiments } = hardCase('ties')
  const [steep] = experiments as [Experiment]
  const hour = samples(3600)

  it.each(ids)('%s, located and clamped: stays where drive and friction tie', (integrator) => {
    for (const experiment of experiments)
      for (const stopping of ['located', 'clamped'] as const) {
        const run = simulate({ ...experiment, integrator, stopping, duration: hour })
        expect(run.outcome).toEqual({ kind: 'at-rest', time: 0 })
        const start = experiment.parameters!.position ?? 0
        const words = [experiment.scene, integrator, stopping]
        measured(name, 'held', words, largest(run.s.map((s) => s - start)), { atMost: 0 })
      }
  })

  it('goes where friction is less by a millionth of a millionth', () => {
    const mu = 1 - 1e-12
    const experiment = having(steep, { muStatic: mu, muKinetic: mu })
    const distance = 0.5 * 9.81 * Math.SQRT1_2 * (1 - mu) * 3600 ** 2
    for (const { id } of secondOrder) {
      const run = simulate({ ...experiment, integrator: id })
      measured(name, 'freed', [id], last(run.s) / distance, { atLeast: 0.999, atMost: 1.001 })
    }
  })

  it.each(ids)('%s, naive: creeps', (integrator) => {
    const run = simulate({ ...steep, integrator, stopping: 'naive', duration: hour })
    measured(name, 'naive', [integrator], largest(run.s), { above: 0 })
  })
})

describe('22 stiff drag', () => {
  const runs = (name: string) =>
    hardCase(name).experiments.map((experiment) => ({
      id: experiment.integrator!,
      experiment,
      run: simulate(experiment),
    }))

  it('c v Δt/m = 1.9: all but Yoshida 4 die down', () => {
    const name = 'below-the-limit-of-drag'
    for (const { id, experiment, run } of runs(name)) {
      if (id === 'yoshida4') {
        expect(run.outcome.kind).toBe('diverged')
        measured(name, 'yoshida', [id], run.steps, { atMost: 10 })
        continue
      }
      expect(run.outcome.kind).toBe('moving')
      measured(name, 'survives', [id], largest(run.v) / 1.9, { atMost: 1 })
      expect(Math.abs(last(run.v))).toBeLessThan(0.1)
      const { order } = integrators.find((each) => each.id === id)!
      if (order > 1) continue
      const located = simulate({ ...experiment, stopping: 'located' })
      expect(located.outcome.kind).toBe('at-rest')
      const time = 0.1 / 1.9
      const rounding = 8 * HALF_ULP
      measured(name, 'rest', [id], located.outcome.time, {
        atLeast: time - rounding,
        atMost: time + rounding,
      })
    }
  })

  it('c v Δt/m = 2.1: four survive', () => {
    const name = 'beyond-the-limit-of-drag'
    for (const { id, run } of runs(name))
      if (['rk4', 'rk8', 'implicit-midpoint'].includes(id)) {
        expect(run.outcome.kind).toBe('moving')
        measured(name, 'survives', [id], largest(run.v) / 2.1, { atMost: 1 })
      } else {
        expect(run.outcome.kind).toBe('diverged')
        measured(name, 'diverged', [id], run.steps, { atMost: 20 })
      }
  })

  it('c v Δt/m = 12: implicit midpoint survives, and all to tolerance', () => {
    const { id: name, experiments } = hardCase('dive-into-stiff-air')
    const [dive] = experiments as [Experiment]
    const { s } = exact(dive, 5)
    for (const integrator of ['velocity-verlet', 'rk4', 'rk8'] as const) {
      const run = simulate({ ...dive, integrator })
      measured(name, 'tolerance', [integrator], Math.abs(last(run.s) - s), { atMost: 5e-9 })
    }
    for (const integrator of ids) {
      const run = simulate({
        ...dive,
        integrator,
        stopping: 'naive',
        timestep: { kind: 'variable' },
      })
      if (integrator === 'implicit-midpoint') {
        expect(run.outcome.kind).toBe('moving')
        measured(name, 'implicit', [], largest(run.v) / 12, { atMost: 1 })
      } else {
        expect(run.outcome.kind).toBe('diverged')
        measured(name, 'diverged', [integrator], run.steps, { atMost: 10 })
      }
    }
  })
})

describe('26 an hour of sliding', () => {
  const { id: name, experiments } = hardCase('hour-of-sliding')
  const [base] = experiments as [Experiment]
  const { s } = exact(base, 3600)

  it.each(secondOrder)('$id: off by rounding only', ({ id }) => {
    for (const fps of [5, 60, 144]) {
      const run = simulate({ ...base, integrator: id, frames: { kind: 'steady', fps } })
      measured(name, 'located', [id, `${fps} fps`], Math.abs(last(run.s) / s - 1), {
        atMost: HALF_ULP * run.frames,
      })
    }
    const run = simulate({
      ...base,
      integrator: id,
      frames: { kind: 'steady', fps: 60 },
      timestep: { kind: 'tolerance', tolerance: 1e-9 },
    })
    measured(name, 'tolerance', [id], Math.abs(last(run.s) / s - 1), {
      atMost: HALF_ULP * 4 * run.frames,
    })
  })

  it.each(firstOrder)('$id: off by ½ a T Δt', ({ id }) => {
    const run = simulate({ ...base, integrator: id, frames: { kind: 'steady', fps: 60 } })
    const bound = s / 3600 / 60
    measured(name, 'euler', [id], Math.abs(last(run.s) - s), {
      atLeast: 0.999999 * bound,
      atMost: 1.000001 * bound,
    })
  })
})

published('limits')
