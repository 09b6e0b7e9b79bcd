import { expect, test } from 'vitest'
import { errorAxis, linearAxis } from '../../src/chart/axis.ts'

const labels = (list: readonly { label: string }[]) =>
  list.map(({ label }) => label.replaceAll('\u202f', ' '))

test('ticks are round, within the axis, and written with as many decimals as their step has', () => {
  expect(labels(linearAxis(0, 1, 's', false).ticks(5))).toEqual([
    '0.0 s',
    '0.2 s',
    '0.4 s',
    '0.6 s',
    '0.8 s',
    '1.0 s',
  ])
  expect(labels(linearAxis(-1.72, 0, 'm').ticks(5))).toEqual([
    '−1.5 m',
    '−1.0 m',
    '−0.5 m',
    '0.0 m',
  ])
  expect(labels(linearAxis(0, 20, 's', false).ticks(4))).toEqual([
    '0 s',
    '5 s',
    '10 s',
    '15 s',
    '20 s',
  ])
  expect(labels(linearAxis(0, 0.003, 's', false).ticks(3))).toEqual([
    '0.000 s',
    '0.001 s',
    '0.002 s',
    '0.003 s',
  ])
  expect(labels(linearAxis(0, 1e6, 's', false).ticks(2))).toEqual(['0 s', '500000 s', '1 × 10⁶ s'])
})

test('an error axis goes by powers of ten, with rounding at its foot', () => {
  const axis = errorAxis(2e-4, 0.25)
  expect(labels(axis.ticks(8))).toEqual(['rounding', '100 µm', '1 mm', '10 mm', '100 mm', '1 m'])
  expect(axis.at(0)).toBe(-5)
  expect(axis.at(1e-3)).toBe(-3)
  expect(labels(errorAxis(3e-10, 2).ticks(6))).toEqual(['rounding', '1 nm', '1 µm', '1 mm', '1 m'])
  expect(labels(errorAxis(1, 5e4).ticks(9))).toEqual([
    'rounding',
    '1 m',
    '10 m',
    '100 m',
    '1 km',
    '10 km',
    '100 km',
  ])
})

test('where all is rounding there still is an axis', () => {
  const axis = errorAxis(Infinity, 0)
  expect(axis.to).toBeGreaterThan(axis.from)
  expect(labels(axis.ticks(6))[0]).toBe('rounding')
})
