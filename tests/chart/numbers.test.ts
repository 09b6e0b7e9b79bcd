import { expect, test } from 'vitest'
import { degrees, metres, place, plain, raw, seconds, speed } from '../../src/chart/numbers.ts'

const ordinary = (text: string) => text.replaceAll('\u202f', ' ')

test.each([
  [0.41, '0.41 m'],
  [-0.2464, '−0.246 m'],
  [12.345, '12.3 m'],
  [1234.5, '1235 m'],
  [-277778.2, '−277 778 m'],
  [1234567, '1.2 × 10⁶ m'],
  [0.0012, '1.2 mm'],
  [0.00999999, '10 mm'],
  [3.2e-5, '32 µm'],
  [3.2e-14, '3.2 × 10⁻⁸ µm'],
  [-0, '0 (to rounding)'],
  [3.1e8, '3.1 × 10⁸ m'],
  [NaN, 'no number'],
])('metres(%s) is %s', (value, text) => {
  expect(ordinary(metres(value))).toBe(text)
})

test.each([
  [1.4674, 0.01, '1.47 m'],
  [0, 0.01, '0.00 m'],
  [-0.001, 0.01, '0.00 m'],
  [-1.5, 0.01, '−1.50 m'],
  [0.16012, 0.001, '0.160 m'],
  [0.00031, 1e-5, '0.31 mm'],
  [4e30, 0.01, '4 × 10³⁰ m'],
])('place(%s, %s) is %s', (value, visible, text) => {
  expect(ordinary(place(value, visible))).toBe(text)
})

test('speeds, angles and times', () => {
  expect(ordinary(speed(-5))).toBe('−5 m/s')
  expect(degrees(12.5)).toBe('12.5°')
  expect([0, 0.7, 12.345, 0.0123, 12e-9].map(seconds).map(ordinary)).toEqual([
    '0.00 s',
    '0.70 s',
    '12.35 s',
    '12.3 ms',
    '12 ns',
  ])
})

test('no figure has more digits than can be read, and raw has all of them', () => {
  for (const value of [1 / 3, 2 / 3e5, 1e5 / 3, 1e20 / 3, 9.9996, 0.1 + 0.2]) {
    expect(plain(value).replace(/\D/g, '').length).toBeLessThanOrEqual(7)
    expect(Number(raw(value))).toBe(value)
  }
})
