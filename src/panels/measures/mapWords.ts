import { html } from 'lit'
import type { NumberOption } from '../../physics/index.ts'
import {
  mappedExperiment,
  rateAt,
  REFERENCE_RATE,
  stableRate,
  rowValue,
} from '../../measure/index.ts'
import type { MapRequest } from '../../measure/index.ts'
import { decadeText, roughSize } from '../../chart/magnitudes.ts'
import { plain, raw } from '../../chart/numbers.ts'
import type { MapCell, MapCells } from './mapCells.ts'
import { parametersOf } from './mapChoice.ts'

/** The parameter that a map is drawn over. */
export function mappedOption({ experiment, parameter }: MapRequest): NumberOption {
  return parametersOf(experiment)[parameter]!
}

/** “Angle 15°”. */
function valueText({ label, unit }: NumberOption, value: number): string {
  return `${label} ${plain(value)}${unit && unit !== '°' ? '\u202f' : ''}${unit}`
}

/** “24.1 fps, angle 15.2°”. */
export function placeText(request: MapRequest, column: number, row: number): string {
  const place = valueText(mappedOption(request), rowValue(request, row)).toLowerCase()
  return `${plain(rateAt(request, column))} fps, ${keepUnits(request, place)}`
}

/** What a cell says, in a few words that can stand after “it”. */
export function cellWords({ kind, value }: MapCell, { of }: MapRequest): string {
  switch (kind) {
    case 'measured': {
      const size = roughSize(value)
      if (of === 'spread')
        return value === 0
          ? `ends where it does at ${REFERENCE_RATE} fps, to rounding`
          : `ends ${size} from where it does at ${REFERENCE_RATE} fps`
      return value === 0 ? 'is exact to rounding' : `is never off by more than ${size}`
    }
    case 'left-the-track':
      return 'leaves the track'
    case 'diverged':
      return 'blows up'
    case 'different':
      return `stays on the track, which at ${REFERENCE_RATE} fps it does not`
    case 'refused':
      return 'can’t be run: the block would not be on the track'
    case 'unknown':
      return 'has no known true motion'
    case 'pending':
      return 'is not measured yet'
  }
}

/** What theory says of the runs on the map, where it says something. */
export function limitWords(request: MapRequest): string {
  const rate = stableRate(mappedExperiment(request, 0, request.rows - 1))
  if (rate === undefined) return ''
  if (rate === Infinity) return 'Theory: blows up at every frame rate, sooner or later'
  if (rate === 0) return 'Theory: blows up at none'
  return 'Theory, without friction: blows up left of this line'
}

/** The whole map in a few sentences. */
export function summary(cells: MapCells): string {
  const { request } = cells
  const total = request.columns * request.rows
  const share = (text: string, count: number) =>
    count > 0 ? [`${percent(count / total)} ${text}`] : []
  const what = request.of === 'spread' ? 'ends the same' : 'is exact'
  const { low, high } = cells.decades()
  const between = cells.count(({ kind, value }) => kind === 'measured' && value > 0)
  return `Of all runs, ${[
    ...share(
      `${what} to rounding`,
      cells.count(({ value }) => value === 0),
    ),
    ...share(`lies between ${decadeText(low)} and ${decadeText(high)}`, between),
    ...share(
      'leaves the track',
      cells.count(({ kind }) => kind === 'left-the-track'),
    ),
    ...share(
      'blows up',
      cells.count(({ kind }) => kind === 'diverged'),
    ),
    ...share(
      `stays on the track as the run at ${REFERENCE_RATE} fps does not`,
      cells.count(({ kind }) => kind === 'different'),
    ),
    ...share(
      'can’t be run',
      cells.count(({ kind }) => kind === 'refused'),
    ),
  ].join(', ')}.`
}

function percent(part: number): string {
  const size = 100 * part
  return size > 99 && size < 100
    ? '99\u202f%'
    : `${size < 1 ? '<\u202f1' : Math.round(size)}\u202f%`
}

/** Units keep their letters’ case when a label is written small. */
function keepUnits(request: MapRequest, text: string): string {
  const { unit } = mappedOption(request)
  return unit ? text.slice(0, text.length - unit.length) + unit : text
}

const COLUMNS = 8
const ROWS = 6

/** Some readings of a map, evenly over all of it. */
export function mapTable(cells: MapCells) {
  const { request } = cells
  const option = mappedOption(request)
  const columns = evenly(request.columns, COLUMNS)
  const rows = evenly(request.rows, ROWS).reverse()
  return html`<div class="scroll" tabindex="0" role="region" aria-label="Frame-rate map, table">
    <table>
      <thead>
        <tr>
          <td></td>
          ${columns.map((column) => html`<th scope="col">${plain(rateAt(request, column))} fps</th>`)}
        </tr>
      </thead>
      <tbody>
        ${rows.map(
          (row) =>
            html`<tr>
              <th scope="row">${valueText(option, rowValue(request, row))}</th>
              ${columns.map((column) => {
                const cell = cells.cell(column, row)
                const text =
                  cell.kind === 'measured' ? roughSize(cell.value) : cellWords(cell, request)
                return html`<td title=${cell.kind === 'measured' ? `${raw(cell.value)} m` : ''}>
                  ${text}
                </td>`
              })}
            </tr>`,
        )}
      </tbody>
    </table>
  </div>`
}

/** So many places, each in the middle of its part of the whole. */
function evenly(whole: number, parts: number): number[] {
  return Array.from({ length: parts }, (_, i) => Math.floor(((i + 0.5) * whole) / parts))
}
