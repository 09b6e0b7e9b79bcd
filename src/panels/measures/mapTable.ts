import { html } from 'lit'
import { rateAt, valueAt } from '../../measure/index.ts'
import { roughSize } from '../../chart/magnitudes.ts'
import { plain, raw } from '../../chart/numbers.ts'
import type { MapCells } from './mapCells.ts'
import { cellWords, mappedOption, valueText } from './mapWords.ts'

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
              <th scope="row">${valueText(option, valueAt(request, row))}</th>
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
