import { describe, expect, it } from 'vitest'
import { stabilityLimit, staysBounded } from '../../src/measure/index.ts'
import { integrators } from '../../src/physics/index.ts'
import type { Integrator, IntegratorId } from '../../src/physics/index.ts'

const methods: readonly (Integrator & { readonly id: IntegratorId })[] = integrators

describe('the stability limit on the frictionless spring', () => {
  it.each(methods.filter(({ stability }) => stability > 0 && stability < Infinity))(
    'of $id is within 1 % of its claim, $stability',
    ({ id, stability }) => {
      expect(Math.abs(stabilityLimit(id) / stability - 1)).toBeLessThan(0.01)
    },
  )

  it.each(methods.filter(({ stability }) => stability === 0))(
    '$id has none: it blows up even at ωΔt = 1/4',
    ({ id }) => {
      expect(stabilityLimit(id)).toBe(0)
    },
  )

  it.each(methods.filter(({ stability }) => stability === Infinity))(
    '$id has none: it holds even at ωΔt = 1000',
    ({ id }) => {
      expect(stabilityLimit(id)).toBe(Infinity)
    },
  )

  it('is a limit: a step below holds and a step above does not', () => {
    expect(staysBounded('velocity-verlet', 1.99)).toBe(true)
    expect(staysBounded('velocity-verlet', 2.01)).toBe(false)
    expect(staysBounded('rk4', 2.82)).toBe(true)
    expect(staysBounded('rk4', 2.83)).toBe(false)
  })
})
