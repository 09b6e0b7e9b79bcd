import { expect, test } from 'vitest'
import { MapCells } from '../../../src/panels/measures/mapCells.ts'
import { cellUnder, mapFrame, mapPlaceOf } from '../../../src/panels/measures/mapDrawing.ts'
import { cellWords, placeText, summary } from '../../../src/panels/measures/mapWords.ts'
import { rampColour } from '../../../src/panels/measures/mapImage.ts'
import { coarseCell, rateAt, rateMap, rowValue } from '../../../src/measure/index.ts'
import type { MapRequest } from '../../../src/measure/index.ts'
import { contrast } from '../../../src/view/palette.ts'

const request: MapRequest = {
  experiment: {
    scene: 'half-pipe',
    parameters: { position: 2.8 },
    integrator: 'explicit-euler',
    duration: 4,
  },
  ...{ of: 'error', parameter: 'radius', from: 0.5, to: 5 },
  ...{ slowest: 5, fastest: 240, columns: 24, rows: 18 },
}

test('a cell that is not computed shows the coarse one in its stead', () => {
  const cells = new MapCells(request)
  const rows = [...rateMap(request)]
  expect(cells.cell(3, 17).kind).toBe('pending')
  for (const row of rows.slice(0, 3)) cells.take(row)
  expect(cells.cell(3, 17)).toEqual(cells.cell(coarseCell(3, 24), coarseCell(17, 18)))
  for (const row of rows.slice(3)) cells.take(row)
  expect(cells.count(({ kind }) => kind === 'pending')).toBe(0)
  const last = rows.at(-1)!
  expect(cells.cell(3, 17).value).toBe(last.values[3])
})

test('the map in words', () => {
  const cells = new MapCells(request)
  for (const row of rateMap(request)) cells.take(row)
  const words = summary(cells)
  expect(words).toMatch(/^Of all runs, .*leaves the track, .*can’t be run\.$/)
  expect(placeText(request, 0, 0)).toBe('5.42 fps, radius 0.625\u202fm')
  expect(cellWords(cells.cell(0, 0), request)).toContain('can’t be run')
  const exact = { kind: 'measured', value: 0 } as const
  expect(cellWords(exact, request)).toBe('is exact to rounding')
  expect(cellWords({ ...exact, value: 0.1234 }, { ...request, of: 'spread' })).toBe(
    'ends 0.12\u202fm from where it does at 60 fps',
  )
})

test('a place goes to a cell, and the cell to its place', () => {
  const frame = mapFrame(800, 400)
  const { left, right, top, bottom } = frame
  expect(cellUnder(request, frame, left + 1, bottom - 1)).toEqual({ column: 0, row: 0 })
  expect(cellUnder(request, frame, right - 1, top + 1)).toEqual({ column: 23, row: 17 })
  expect(cellUnder(request, frame, left - 1, top + 1)).toBeUndefined()
  const { column, row } = mapPlaceOf(request, rateAt(request, 7), rowValue(request, 11))!
  // Rates and values are round: to three and four digits, which is less than a tenth of a cell.
  expect(Math.abs(column - 7)).toBeLessThan(0.1)
  expect(Math.abs(row - 11)).toBeLessThan(0.1)
  expect(mapPlaceOf(request, 1000, 1)).toBeUndefined()
})

test('the ramp goes from the paper’s side to the other, evenly', () => {
  const white = [255, 255, 255] as const
  for (const dark of [false, true]) {
    const steps = Array.from({ length: 11 }, (_, i) => contrast(rampColour(i / 10, dark), white))
    const rising = steps.slice(1).map((each, i) => each > steps[i]!)
    expect(rising).toEqual(rising.map(() => !dark))
  }
})
