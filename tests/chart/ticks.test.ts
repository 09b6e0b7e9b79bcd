import { expect, test } from 'vitest'
import { roundAbove, roundBelow, toStep } from '../../src/chart/ticks.ts'

test.each([
  [0.2, 0.2, 0.2],
  [0.3, 0.2, 0.5],
  [0.99, 0.5, 1],
  [1, 1, 1],
  [7e-5, 5e-5, 1e-4],
  [1e6, 1e6, 1e6],
  [43, 20, 50],
])('around %s the round numbers are %s and %s', (limit, below, above) => {
  expect([roundBelow(limit), roundAbove(limit)]).toEqual([below, above])
})

test('multiples of a step are short decimals', () => {
  expect(toStep(0.299, 0.1)).toBe(0.3)
  expect(toStep(1.4674, 0.02)).toBe(1.46)
  expect(Object.is(toStep(-0.001, 0.1), 0)).toBe(true)
})
