import { html } from 'lit'
import { metres, plain, raw } from '../../view/numbers.ts'
import type { CostKind } from './costs.ts'
import type { DiagramCurve, DiagramPoint } from './points.ts'

/** The diagram in figures: a row for each rate, the error and the cost of each method. */
export function diagramTable(curves: readonly DiagramCurve[], kind: CostKind) {
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
      </tbody>
    </table>
  </div>`
}

function cell({ error, cost, whole, outcome }: DiagramPoint, kind: CostKind) {
  const text = whole ? metres(Number(error.toPrecision(2))) : failureText(outcome)
  return html`<td title="${raw(error)} m for ${raw(cost)}">
    ${text}<small>${kind.text(cost)}</small>
  </td>`
}

function failureText(outcome: DiagramPoint['outcome']): string {
  return outcome === 'diverged'
    ? 'blew up'
    : outcome === 'left-the-track'
      ? 'left the track'
      : 'not known'
}
