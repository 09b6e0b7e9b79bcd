import { expect, test } from 'vitest'
import { contrast, readable } from '../../src/view/palette.ts'
import type { Rgb } from '../../src/view/palette.ts'

const white: Rgb = [255, 255, 255]
const ink: Rgb = [29, 33, 39]

test('contrast as WCAG gives it', () => {
  expect(contrast(white, [0, 0, 0])).toBe(21)
  expect(contrast([118, 118, 118], white)).toBeCloseTo(4.54, 2)
})

test('a colour that can be read stays, one that can’t is mixed with ink until it can', () => {
  expect(readable([0, 90, 160], white, ink)).toEqual([0, 90, 160])
  const yellow = readable([240, 228, 66], white, ink)
  expect(contrast(yellow, white)).toBeGreaterThanOrEqual(4.5)
  expect(yellow[0]).toBeGreaterThan(yellow[2])
})
