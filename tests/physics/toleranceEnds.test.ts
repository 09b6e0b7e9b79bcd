/** Steps to a tolerance come to an end with every rule: naive friction trembles until its tries are given up. */
import { describe, expect, it } from 'vitest'
import { integrators, scenes, simulate, stoppings } from '../../src/physics/index.ts'
import { last } from './truth.ts'

describe.each(scenes)('$id', ({ id: scene }) => {
  it('takes every rule and method, and ends in numbers', () => {
    for (const { id: integrator } of integrators)
      for (const { id: stopping } of stoppings) {
        const timestep = { kind: 'tolerance', tolerance: 1e-3 } as const
        const run = simulate({ scene, integrator, stopping, timestep, duration: 0.5 })
        expect(run.s.every(Number.isFinite)).toBe(true)
        expect(run.lostTime).toBe(0)
        if (run.outcome.kind !== 'moving') continue
        expect(last(run.stateTime)).toBe(0.5)
      }
  })
})

describe('the policy', () => {
  const timestep = { kind: 'tolerance', tolerance: 1e-9 } as const

  it('ends as diverged where a rule never comes to an end: naive friction trembles at every step', () => {
    const run = simulate({ scene: 'ramp', parameters: { angle: 5 }, stopping: 'naive', timestep })
    expect(run.outcome.kind).toBe('diverged')
  })
})
