import { html } from 'lit'
import type { Simulated } from '../../lab/state/simulation.ts'
import type { PlotKind } from './kinds.ts'
import { tableOf } from './table.ts'

/** A plot as a table, which scrolls inside itself. */
export function plotTable(kind: PlotKind, simulated: Simulated) {
  const { head, rows } = tableOf(kind, simulated)
  return html`<div class="scroll" tabindex="0" role="region" aria-label="${kind.title}, table">
    <table>
      <thead>
        <tr>
          ${head.map((text) => html`<th scope="col">${text}</th>`)}
        </tr>
      </thead>
      <tbody>
        ${rows.map(
          ({ time, cells }) =>
            html`<tr>
              <th scope="row">${time}</th>
              ${cells.map(({ text, title }) => html`<td title=${title}>${text}</td>`)}
            </tr>`,
        )}
      </tbody>
    </table>
  </div>`
}
