import { html } from 'lit'
import { roughSize } from '../../chart/magnitudes.ts'
import { plain, raw } from '../../chart/numbers.ts'
import { errorText } from './diagramWords.ts'
import type { CostKind, DiagramCurve, DiagramPoint } from './points.ts'

/** The diagram in numbers: a row for each rate, tolerance and runner of the lab, the error and the cost of each method. */
export function diagramTable(
  curves: readonly DiagramCurve[],
  runners: readonly DiagramPoint[],
  kind: CostKind,
) {
  const byRate = curves.filter(({ by }) => by === 'rate')
  const byTolerance = curves.filter(({ by }) => by === 'tolerance')
  const rates = byRate[0]?.points.map(({ setting }) => setting) ?? []
  const all = byTolerance.flatMap(({ points }) => points.map(({ setting }) => setting))
  const tolerances = [...new Set(all)].sort((a, b) => b - a)
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
          ${byRate.map(({ label, order }) => html`<th scope="col">${label}<small>${order}</small></th>`)}
        </tr>
      </thead>
      <tbody>
        ${rates.map(
          (rate, row) =>
            html`<tr>
              <th scope="row">${plain(rate)}</th>
              ${byRate.map(({ points }) => cell(points[row]!, kind))}
            </tr>`,
        )}
        ${tolerances.map(
          (tolerance) =>
            html`<tr>
              <th scope="row">to ${roughSize(tolerance)}<small>a second</small></th>
              ${byRate.map(({ method }) => cellAt(byTolerance, method, tolerance, kind))}
            </tr>`,
        )}
        ${runners.map(
          (point) =>
            html`<tr>
              <th scope="row">${point.runner!.name}<small>in the lab</small></th>
              ${byRate.map(({ method }) => (method === point.method ? cell(point, kind) : html`<td></td>`))}
            </tr>`,
        )}
      </tbody>
    </table>
  </div>`
}

/** Nothing where a method is not asked for so small a tolerance. */
function cellAt(
  curves: readonly DiagramCurve[],
  method: string,
  tolerance: number,
  kind: CostKind,
) {
  const points = curves.find((curve) => curve.method === method)?.points
  const point = points?.find(({ setting }) => setting === tolerance)
  return point ? cell(point, kind) : html`<td></td>`
}

function cell(point: DiagramPoint, kind: CostKind) {
  return html`<td title="${raw(point.error)} m for ${raw(point.cost)}">
    ${errorText(point)}<small>${kind.text(point.cost)}</small>
  </td>`
}
