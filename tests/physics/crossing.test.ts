import { describe, expect, it } from 'vitest'
import { crossing } from '../../src/physics/exact/phase.ts'

/** Where a polynomial takes a value up to `end`, and how often it was evaluated to find that. */
function find(coefficients: readonly number[], target: number, end: number) {
  let reads = 0
  const counted = new Proxy(coefficients, {
    get: (c, name) => {
      if (name === 'length') return c.length
      reads++
      return c[Number(name)]
    },
  })
  const x = crossing(counted, target, end)
  return { x, evaluations: reads / coefficients.length }
}

/** Twice: the rounding of the root itself, and of the polynomial's value there over its slope. */
const ROUNDING = 4 * Number.EPSILON

describe('where a polynomial takes a value', () => {
  it.each([
    { c: [-2, 0, 1], target: 0, end: 2, root: Math.SQRT2 },
    { c: [2, 0, -1], target: 0, end: 2, root: Math.SQRT2 },
    { c: [0, 0, 1], target: 2, end: 1.5, root: Math.SQRT2 },
    { c: [0, 0, 0, 1], target: 1e-9, end: 0.0011, root: 1e-3 },
    { c: [0, 1, 1], target: 1001 * 1000, end: 1010, root: 1000 },
    { c: [5, -1], target: 3, end: 3, root: 2 },
    { c: [0, 1], target: 2, end: 2, root: 2 },
  ])('is found to rounding in a few steps by Newton’s method: $c at $target', (each) => {
    const { x, evaluations } = find(each.c, each.target, each.end)
    expect(Math.abs(x - each.root)).toBeLessThanOrEqual(ROUNDING * each.root)
    // Digits double with each step; bisection would take fifty.
    expect(evaluations).toBeLessThanOrEqual(10)
  })

  it('is found between its bounds where Newton’s method would leave them at the far end', () => {
    // u − u³/3.2 about u = x − 0.1: the slope points away from the root at 1.5, to another beyond it.
    const third = 1 / 3.2
    const cubic = [-0.1 + third * 0.1 ** 3, 1 - 3 * third * 0.01, 3 * third * 0.1, -third]
    const { x, evaluations } = find(cubic, 0, 1.5)
    expect(Math.abs(x - 0.1)).toBeLessThanOrEqual(1e-16)
    expect(evaluations).toBeLessThanOrEqual(15)
  })

  it('is found between its bounds where Newton’s method would leave them at 0', () => {
    // 3x² − 2x³ is nearly flat at 0.999: the next guess would be far below 0, where it takes the value again.
    const { x, evaluations } = find([0, 0, 3, -2], 0.5, 0.999)
    expect(Math.abs(x - 0.5)).toBeLessThanOrEqual(ROUNDING)
    expect(evaluations).toBeLessThanOrEqual(15)
  })

  it('is found in tens of steps where Newton’s method creeps', () => {
    // Each of its steps on x⁹ takes a ninth of what is left: 130 of them from 1 to the root.
    const { x, evaluations } = find([0, 0, 0, 0, 0, 0, 0, 0, 0, 1], 1e-60, 1)
    const root = 10 ** (-60 / 9)
    expect(Math.abs(x - root)).toBeLessThanOrEqual(ROUNDING * root)
    expect(evaluations).toBeLessThanOrEqual(100)
  })
})
