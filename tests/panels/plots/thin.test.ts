import fc from 'fast-check'
import { expect, test } from 'vitest'
import { thinColumns, thinPath } from '../../../src/panels/plots/thin.ts'

const times = (count: number) => Float64Array.from({ length: count }, (_, i) => i / count)

test('where columns are narrow every row is kept', () => {
  const x = times(50)
  const y = x.map((each) => Math.sin(9 * each))
  expect(thinColumns(x, y, 1 / 200)).toEqual(Array.from(x, (_, i) => i))
})

test('at most two rows a column, with its extremes, the first and the last row', () => {
  const values = fc.array(fc.double({ min: -10, max: 10, noNaN: true }), {
    minLength: 1,
    maxLength: 600,
  })
  fc.assert(
    fc.property(values, fc.integer({ min: 1, max: 60 }), (y, columns) => {
      const x = times(y.length)
      const column = 1 / columns
      const rows = thinColumns(x, y, column)
      expect(rows).toEqual([...new Set(rows)].sort((a, b) => a - b))
      expect(rows.length).toBeLessThanOrEqual(2 * columns + 2)
      expect(rows[0]).toBe(0)
      expect(rows.at(-1)).toBe(y.length - 1)
      for (let i = 0; i < columns; i++) {
        const all = y.filter((_, row) => Math.floor(x[row]! / column) === i)
        const kept = rows.filter((row) => Math.floor(x[row]! / column) === i).map((row) => y[row]!)
        if (all.length === 0) continue
        expect(Math.min(...kept)).toBe(Math.min(...all))
        expect(Math.max(...kept)).toBe(Math.max(...all))
      }
    }),
  )
})

test('one spike among thousands of rows is not lost', () => {
  const y = new Float64Array(2400)
  y[1234] = 1
  expect(thinColumns(times(2400), y, 1 / 300)).toContain(1234)
})

test('what is no finite number is left out', () => {
  const y = [1, NaN, 2, Infinity, -Infinity]
  expect(thinColumns(times(5), y, 1)).toEqual([0, 2])
  expect(thinColumns(times(2), [NaN, NaN], 1)).toEqual([])
  expect(thinPath(times(5), y, 0.001, 0.001)).toEqual([0, 2])
  expect(thinPath([], [], 1, 1)).toEqual([])
})

test('of a path that goes anywhere, no row is further from a kept one than a cell, and the last is kept', () => {
  const point = fc.tuple(
    fc.double({ min: 0, max: 1, noNaN: true }),
    fc.double({ min: 0, max: 1, noNaN: true }),
  )
  fc.assert(
    fc.property(fc.array(point, { minLength: 1, maxLength: 300 }), (points) => {
      const x = points.map(([each]) => each)
      const y = points.map(([, each]) => each)
      const rows = thinPath(x, y, 0.1, 0.2)
      expect(rows.at(-1)).toBe(points.length - 1)
      points.forEach(([px, py]) => {
        expect(
          rows.some((row) => Math.abs(x[row]! - px) <= 0.1 && Math.abs(y[row]! - py) <= 0.2),
        ).toBe(true)
      })
    }),
  )
})
