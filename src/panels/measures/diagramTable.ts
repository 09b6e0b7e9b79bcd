import { html } from 'lit'
import { plain, raw } from '../../chart/numbers.ts'
import { errorText } from './diagramWords.ts'
import type { CostKind, DiagramCurve, DiagramPoint } from './points.ts'

/** The diagram in numbers: a row for each rate and each runner of the lab, the error and the cost of each method. */
export function diagramTable(
  curves: readonly DiagramCurve[],
  runners: readonly DiagramPoint[],
  kind: CostKind,
) {
  const rates = curves[0]?.points.map(({ rate }) => rate) ?? []
  return html`<div
    class="scroll"
    tabindex="0"
    role="region"
    aria-label="Speed against error, table"
  >
    <table>
      <caption>
        Largest error of the run, and under it the cost of a simulated second
        (${kind.label.toLowerCase()})
      </caption>
      <thead>
        <tr>
          <th scope="col">steps a second</th>
          ${curves.map(({ label, order }) => html`<th scope="col">${label}<small>${order}</small></th>`)}
        </tr>
      </thead>
      <tbody>
        ${rates.map(
          (rate, row) =>
            html`<tr>
              <th scope="row">${plain(rate)}</th>
              ${curves.map(({ points }) => cell(points[row]!, kind))}
            </tr>`,
        )}
        ${runners.map(
          (point) =>
            html`<tr>
              <th scope="row">${point.runner!.name}<small>in the lab</small></th>
              ${curves.map(({ method }) => (method === point.method ? cell(point, kind) : html`<td></td>`))}
            </tr>`,
        )}
      </tbody>
    </table>
  </div>`
}

function cell(point: DiagramPoint, kind: CostKind) {
  return html`<td title="${raw(point.error)} m for ${raw(point.cost)}">
    ${errorText(point)}<small>${kind.text(point.cost, point.mostCost)}</small>
  </td>`
}
