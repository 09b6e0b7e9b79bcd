import { expect, it } from 'vitest'
import { dot, length, plus, times, zero } from '../../src/physics/vector.ts'

const a = { x: 3, y: -4 }
const b = { x: 0.5, y: 2 }

it('vectors add up, however many, and are left as they were', () => {
  expect(plus(a, b, { x: 10, y: 20 })).toEqual({ x: 13.5, y: 18 })
  expect(plus(a, zero)).toEqual(a)
  expect(a).toEqual({ x: 3, y: -4 })
})

it('a vector is scaled in both components', () => {
  expect(times(-2, a)).toEqual({ x: -6, y: 8 })
})

it('the dot product is that of the components, and a vector with itself its length squared', () => {
  expect(dot(a, b)).toBe(-6.5)
  expect(length(a)).toBe(5)
  expect(dot(a, a)).toBe(25)
  expect(length({ x: -5, y: 0 })).toBe(5)
})
