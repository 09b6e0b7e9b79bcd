import { html, nothing } from 'lit'
import { integrators } from '../../physics/index.ts'
import { cheapest, sweepRates } from '../../measure/index.ts'
import { decadeText, roughSize } from '../../chart/magnitudes.ts'
import { plain, raw } from '../../chart/numbers.ts'
import type { CostKind, DiagramCurve, DiagramPoint } from './points.ts'

/** Errors that people ask for, as powers of ten of a metre, and the last: none but rounding. */
const wanted = [-1, -2, -3, -6, -9]

/** What to use for an error. */
export interface Advice {
  readonly error: string
  readonly point: DiagramPoint
}

/** The frontier in words: the cheapest way to each error that people would ask for, each way named once. */
export function advice(curves: readonly DiagramCurve[]): Advice[] {
  const offers = curves.flatMap(({ points }) => points.filter(({ whole }) => whole))
  const found: Advice[] = []
  const add = (error: string, tolerance: number) => {
    const point = cheapest(offers, tolerance)
    if (!point) return
    // A way to a smaller error also serves a larger one.
    if (found.at(-1)?.point === point) found.pop()
    found.push({ error, point })
  }
  for (const exponent of wanted) add(decadeText(exponent), 10 ** exponent)
  add('no error but rounding', 0)
  return found
}

/** The error below which no point of the diagram comes, if that is more than rounding. */
export function leastError(curves: readonly DiagramCurve[]): number {
  const errors = curves.flatMap(({ points }) => points.filter(({ whole }) => whole))
  return Math.min(...errors.map(({ error }) => error))
}

/**
 * Whose run a point is: “Velocity Verlet at 30 steps a second”, “Runge–Kutta 8 to 1 nm a second”, “30 fps in the lab”.
 */
export function pointName({ method, by, setting, runner }: DiagramPoint): string {
  const { label } = integrators.find(({ id }) => id === method)!
  if (runner) return `${runner.name} in the lab, ${label}`
  return by === 'rate'
    ? `${label} at ${plain(setting)} steps a second`
    : `${label} to ${roughSize(setting)} a second`
}

/** A point's error, or why it has none, in very few words. */
export function errorText({ error, outcome, whole }: DiagramPoint): string {
  if (whole) return roughSize(error)
  return outcome === 'diverged'
    ? 'blew up'
    : outcome === 'left-the-track'
      ? 'left the track'
      : 'not known'
}

/** What a point says, in a sentence. */
export function pointWords(
  { error, cost, mostCost, outcome, whole }: DiagramPoint,
  kind: CostKind,
): string {
  const price = `for ${kind.inWords(cost, mostCost)}`
  if (outcome === 'left-the-track') return `left the track, ${price}`
  if (outcome === 'diverged') return `blew up, ${price}`
  if (!whole) return 'the true motion is not known here'
  const size = error === 0 ? 'exact to rounding' : `never off by more than ${roughSize(error)}`
  return `${size}, ${price}`
}

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

/**
 * The diagram in numbers: a row for each rate, tolerance and runner of the lab, the error and the cost of each method.
 */
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
    ${errorText(point)}<small>${kind.text(point.cost, point.mostCost)}</small>
  </td>`
}
