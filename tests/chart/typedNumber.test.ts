import { expect, test } from 'vitest'
import { shownNumber, writeNumber } from '../../src/chart/numbers.ts'
import {
  asTyped,
  isAmbiguous,
  readNumber,
  readTyped,
  typedItems,
} from '../../src/chart/typedNumber.ts'

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

test.each([
  ['12,5', '°', 12.5],
  ['12.5°', '°', 12.5],
  ['−12,5 °', '°', -12.5],
  ['20 deg', '°', 20],
  ['30 fps', 'fps', 30],
  ['59,94 Hz', 'fps', 59.94],
  ['144FPS', 'fps', 144],
  ['1/60 s', 's', 1 / 60],
  ['16.7 ms', 's', 0.0167],
  ['16,7ms', 's', 0.0167],
  ['500 µs', 's', 0.0005],
  ['5 min', 's', 300],
  ['3 s', 's', 3],
  ['25 cm', 'm', 0.25],
  ['2 m', 'm', 2],
  ['18 km/h', 'm/s', 5],
  ['9,81 m/s²', 'm/s²', 9.81],
  ['9.81 m/s2', 'm/s²', 9.81],
  ['250 g', 'kg', 0.25],
  ['40 N/m', 'N/m', 40],
  ['0,125', '', 0.125],
  ['1e-3', '', 0.001],
])('“%s” typed in %s is %d', (text, unit, value) => expect(readTyped(text, unit)).toBe(value))

test.each([
  ['30 m', '°'],
  ['30 s', 'fps'],
  ['5 fps', ''],
  ['fps', 'fps'],
  ['1,2,3', ''],
  ['1.234,5', ''],
  ['12,', ''],
  ['1,234', ''],
])('“%s” typed in %s is no number', (text, unit) => expect(readTyped(text, unit)).toBeUndefined())

test('a comma before three digits may mean thousands, but not after a zero', () => {
  for (const text of ['1,234', '-12,500', ' 999,000 m ']) expect(isAmbiguous(text)).toBe(true)
  for (const text of ['0,125', '1,23', '1,2345', '1234,567', '12.5'])
    expect(isAmbiguous(text)).toBe(false)
})

test.each([
  ['0.016, 0.033', ['0.016', '0.033']],
  ['0.016 0.033\t0.02', ['0.016', '0.033', '0.02']],
  ['0,016 0,033', ['0,016', '0,033']],
  ['0,016;0,033', ['0,016', '0,033']],
  ['1,2', ['1', '2']],
  ['16,7 ms 33,3 ms', ['16,7ms', '33,3ms']],
  ['0.02 soon', ['0.02', 'soon']],
  [' ', []],
])('the list “%s” has its items', (text, items) => expect(typedItems(text)).toEqual(items))

test('where the browser’s language has a decimal comma, a field has it too, and reads it as nothing else', () => {
  for (const value of [9.81, 1.234, -0.5, 1e-7, 1.5e-7, 12, 1 / 60])
    for (const written of [writeNumber(value), shownNumber(value)]) {
      expect(asTyped(written, ',')).not.toContain('.')
      expect(asTyped(written, '.')).toBe(written)
      expect(readTyped(asTyped(written, ','), '', ',')).toBe(readNumber(written))
    }
  expect(isAmbiguous('1,234', ',')).toBe(false)
  expect(isAmbiguous('1,234', '.')).toBe(true)
})
