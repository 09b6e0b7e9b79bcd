import { expect, test } from 'vitest'
import { thin } from '../../src/view/strobe.ts'

test('of frames in the same cell the first is kept', () => {
  expect(thin([0, 0.1, 0.9, 1, 1.5, 2.2, 0.2], 0, 3, 1)).toEqual([0, 3, 5])
})

test('frames out of the picture, and those without a number, are left out', () => {
  expect(thin([-1, 0, 5, 10, 11, NaN, 1e300], 0, 10, 1)).toEqual([1, 2, 3])
})

test('as many dots as there are cells at most, however many frames', () => {
  const s = Array.from({ length: 5000 }, (_, i) => Math.sin(i))
  expect(thin(s, -1, 1, 0.01)).toHaveLength(200)
})
