import { expect, test } from 'vitest'
import { shownNumber, writeNumber } from '../../src/chart/numbers.ts'
import { readNumber } from '../../src/chart/typedNumber.ts'

test.each([
  ['1e-3', 0.001],
  [' 0.5 ', 0.5],
  ['.5', 0.5],
  ['5.', 5],
  ['-5', -5],
  ['−5', -5],
  ['+1E2', 100],
  ['1e−3', 0.001],
  ['1/60', 1 / 60],
  ['-1 / 3', -1 / 3],
  ['1/0', Infinity],
])('%s is a number', (text, value) => expect(readNumber(text)).toBe(value))

test.each(['', ' ', 'x', '1,5', '0x10', 'Infinity', 'NaN', '1/2/3', '/2', '1e', '--1', '1 2'])(
  '“%s” is none',
  (text) => expect(readNumber(text)).toBeUndefined(),
)

test('what is written is read back as the very same number', () => {
  const values = [0, 1, -1, 0.1, 1e-9, 1e300, -5e-324, 123456.789, Math.PI, -1 / 7]
  for (let n = 1; n <= 1000; n++) values.push(1 / n, -1 / n, n / 7, Math.sqrt(n) * 1e-5)
  for (const value of values) expect(readNumber(writeNumber(value))).toBe(value)
})

test('fractions are written where decimals would have no end', () => {
  expect(writeNumber(1 / 60)).toBe('1/60')
  expect(writeNumber(1 / 240)).toBe('1/240')
  expect(writeNumber(1 / 50)).toBe('0.02')
  expect(writeNumber(9.81)).toBe('9.81')
})

test('a field shows a true minus and no idle digits', () => {
  expect(shownNumber(-5)).toBe('−5')
  expect(shownNumber(Math.PI)).toBe('3.14159')
  expect(shownNumber(1e-12)).toBe('1e−12')
})
