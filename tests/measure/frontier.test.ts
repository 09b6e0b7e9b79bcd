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

test('errors and costs that are not finite beat nothing, wherever they stand', () => {
  const good = [
    { cost: 5, error: 0.1 },
    { cost: 10, error: 0.01 },
    { cost: 20, error: 0.001 },
  ]
  for (const bad of [
    { cost: 1, error: NaN },
    { cost: 7, error: Infinity },
    { cost: NaN, error: 0 },
    { cost: Infinity, error: 0 },
  ])
    for (let place = 0; place <= good.length; place++) {
      const offers = [...good.slice(0, place), bad, ...good.slice(place)]
      expect(frontier(offers)).toEqual(good)
      expect(cheapest(offers, 0.01)).toEqual(good[1])
      expect(frontier([bad])).toEqual([])
    }
})

test.each([1, 1e3, 1e9])('rounding is relative to a path of %d m', (scale) => {
  const offers = [
    { cost: 5, error: 9e-12 * scale },
    { cost: 10, error: 0 },
  ]
  expect(frontier(offers, scale)).toEqual([offers[0]])
  expect(cheapest(offers, 0, scale)).toEqual(offers[0])
  const more = [{ cost: 5, error: 1.1e-11 * scale }, offers[1]!]
  expect(frontier(more, scale)).toEqual(more)
})

test('the cheapest for a tolerance', () => {
  expect(cheapest(all, 0.05)).toEqual({ name: 'verlet', cost: 20, error: 0.025 })
  expect(cheapest(all, 0.1)!.name).toBe('euler')
  expect(cheapest(all, 1e-6)).toBeUndefined()
  expect(cheapest([], 1)).toBeUndefined()
})
