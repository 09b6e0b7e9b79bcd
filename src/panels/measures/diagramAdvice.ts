import { html, nothing } from 'lit'
import { sweepRates } from '../../measure/index.ts'
import { roughSize } from '../../chart/magnitudes.ts'
import { plain } from '../../chart/numbers.ts'
import { advice, leastError, pointName } from './diagramWords.ts'
import type { DiagramCurve, DiagramPoint } from './points.ts'

/**
 * What to use for which error.
 *
 * @param cost by what it is the cheapest
 * @param show called with the point whose run the reader wants to see
 */
export function diagramAdvice(
  curves: readonly DiagramCurve[],
  cost: string,
  show: (point: DiagramPoint) => void,
) {
  const found = advice(curves)
  const least = leastError(curves)
  return html`<div class="advice">
    <p class="title">What to use here <span class="soft">by ${cost.toLowerCase()}</span></p>
    <ul>
      ${found.map(
        ({ error, point }) =>
          html`<li>
            For <b>${error}</b>, use
            <button type="button" class="in-text" @click=${() => show(point)}>
              ${pointName(point)}</button
            >.
          </li>`,
      )}
    </ul>
    ${
      found.length > 0 && least > 1e-9
        ? html`<p class="soft">
            Nothing here comes nearer than ${roughSize(least)} with up to
            ${plain(sweepRates.at(-1)!)} steps a second.
          </p>`
        : nothing
    }
  </div>`
}
