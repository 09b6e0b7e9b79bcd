import { html } from 'lit'
import type { Trajectory } from '../../physics/index.ts'
import { fixed, plain, raw } from '../../chart/numbers.ts'
import { rowAt } from '../../view/timeline.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import type { PlotKind, PlotQuantity } from './kinds.ts'

/** A plot in numbers. */
export interface PlotTable {
  /** With units; the first is the time's. */
  readonly head: readonly string[]
  readonly rows: readonly { readonly time: string; readonly cells: readonly TableCell[] }[]
}

interface TableCell {
  readonly text: string
  readonly title: string
}

/** Rows apart from that of the start. */
const MOST = 24

/** The values of every visible runner at its frames nearest to even times, and the exact ones of those times. */
export function tableOf({ over, of, isExactHidden }: PlotKind, simulated: Simulated): PlotTable {
  const { exact, visible, state } = simulated
  const quantities = over ? [over, of] : [of]
  const frames = Math.max(1, ...visible.map(({ trajectory }) => trajectory.frames))
  const count = Math.min(MOST, frames)
  const times = Array.from({ length: count + 1 }, (_, i) => (state.duration * i) / count)
  const names = [
    ...visible.map(({ name }) => name),
    ...(of.ofExact && !isExactHidden ? ['exact'] : []),
  ]
  const decimals = Math.max(2, 2 - Math.floor(Math.log10(state.duration || 1)))
  return {
    head: [
      'time (s)',
      ...names.flatMap((name) =>
        quantities.map(({ label, unit }) => `${name}, ${label} (${unit})`),
      ),
    ],
    rows: times.map((time) => {
      const cells = visible.flatMap(({ trajectory }) => {
        const row = nearestRow(trajectory, time)
        return quantities.map((quantity) =>
          cell(quantity, quantity.values(trajectory)[row]!, trajectory.time[row]!),
        )
      })
      const truth = exact(time, { s: 0, v: 0 })
      const last = quantities.flatMap((quantity) =>
        quantity.ofExact && !isExactHidden
          ? [cell(quantity, quantity.ofExact(truth, simulated), time)]
          : [],
      )
      return { time: fixed(time, decimals), cells: [...cells, ...last] }
    }),
  }
}

/** The row of the frame that is nearest to a time [s]. */
export function nearestRow(trajectory: Trajectory, time: number): number {
  const row = rowAt(trajectory, time)
  const { time: times } = trajectory
  const next = times[row + 1]
  return next !== undefined && next - time < time - times[row]! ? row + 1 : row
}

function cell(quantity: PlotQuantity, value: number, time: number): TableCell {
  return {
    text: numberText(quantity, value),
    title: `${raw(value)} ${quantity.unit} at t = ${raw(time)} s`,
  }
}

/** Without its unit, which stands in the head. */
function numberText({ residual }: PlotQuantity, value: number): string {
  const size = Math.abs(value)
  if (residual && size === 0) return '0 (to rounding)'
  return size < 1e4 && (!residual || size >= 0.01) ? fixed(value, 3) : plain(value)
}

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
