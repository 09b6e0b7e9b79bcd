import { expect, test } from 'vitest'
import { cheapest, frontier } from '../../src/measure/index.ts'

const euler = [10, 20, 40, 80].map((cost) => ({ name: 'euler', cost, error: 1 / cost }))
const verlet = [20, 40, 80].map((cost) => ({ name: 'verlet', cost, error: 10 / cost ** 2 }))
const all = [...verlet, ...euler]

test('the frontier is what nothing beats', () => {
  const best = frontier(all)
  expect(best.map(({ name, cost }) => [name, cost])).toEqual([
    ['euler', 10],
    ['verlet', 20],
    ['verlet', 40],
    ['verlet', 80],
  ])
  for (const offer of all)
    expect(best.some(({ cost, error }) => cost <= offer.cost && error <= offer.error)).toBe(true)
})

test('errors that are rounding are no better than each other', () => {
  const exact = [
    { cost: 5, error: 3e-15 },
    { cost: 10, error: 0 },
  ]
  expect(frontier(exact)).toEqual([exact[0]])
})

test('the cheapest for a tolerance', () => {
  expect(cheapest(all, 0.05)).toEqual({ name: 'verlet', cost: 20, error: 0.025 })
  expect(cheapest(all, 0.1)!.name).toBe('euler')
  expect(cheapest(all, 1e-6)).toBeUndefined()
  expect(cheapest([], 1)).toBeUndefined()
})
