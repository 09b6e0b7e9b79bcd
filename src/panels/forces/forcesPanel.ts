import { html, nothing } from 'lit'
import type { Vector } from '../../physics/index.ts'
import { raw } from '../../chart/numbers.ts'
import { dot, length } from '../../physics/index.ts'
import { atNow } from '../../lab/playback/atNow.ts'
import type { Forces } from './forces.ts'
import { lookedAt, arrowNames } from './forcesPicture.ts'
import type { Looked } from './forcesPicture.ts'
import { frictionText, quantity } from './forcesText.ts'
import type { LabView } from '../../lab/labView.ts'

/** The switch for the forces, and while it is on a legend whose figures are those that the arrows are drawn from. */
export function forcesPanel(lab: LabView, shown: boolean, show: (shown: boolean) => void) {
  const looked = shown ? lookedAt(lab) : undefined
  return html`<section class="forces">
    <div class="forces-head">
      <h2>${looked ? html`Forces on the ${looked.runner.name} block` : 'Forces'}</h2>
      <label>
        <input
          type="checkbox"
          .checked=${shown}
          @change=${(event: Event) => show((event.target as HTMLInputElement).checked)}
        />
        Show forces
      </label>
    </div>
    ${shown ? atNow(lab.playback, () => legend(lab, lookedAt(lab))) : nothing}
  </section>`
}

function legend(lab: LabView, looked: Looked | undefined) {
  if (!looked) return html`<p>The selected runner is hidden.</p>`
  const { forces, runner } = looked
  if (!forces) {
    const { kind } = runner.trajectory.outcome
    const why = kind === 'diverged' ? 'The run has blown up' : 'The block has left the track'
    return html`<p>${why}: no forces are computed any more.</p>`
  }
  return html`<div class="forces-body">
    ${table(lab, looked, forces)} ${frictionLine(looked, forces)}
  </div>`
}

function table(lab: LabView, { largest }: Looked, { vectors, velocity }: Forces) {
  const { scene } = lab.simulated
  const arrow = scene.id === 'fall' ? '↓' : scene.facing > 0 ? '→' : '←'
  const row = (name: unknown, value: Vector, unit: string, most: number) =>
    html`<tr>
      <th scope="row">${name}<span class="unit-beside" aria-hidden="true">, ${unit}</span></th>
      ${[length(value), dot(value, vectors.along), dot(value, vectors.across)].map(
        (each) =>
          html`<td title="${raw(each)} ${unit}">
            ${quantity(each, most)}<span class="unit">&thinsp;${unit}</span>
          </td>`,
      )}
    </tr>`
  return html`<table>
    <thead>
      <tr>
        <td></td>
        <th scope="col">Size</th>
        <th scope="col" title="In the direction in which s grows">
          Along <span aria-hidden="true">${arrow}</span>
        </th>
        <th scope="col" title="Away from the track">Across</th>
      </tr>
    </thead>
    <tbody>
      ${arrowNames(lab).map(({ id, tag, name }) =>
        row(
          html`<span class="arrow ${id}"><span class="tag">${tag}</span> ${name}</span>`,
          id === 'velocity' ? velocity : vectors[id],
          id === 'velocity' ? 'm/s' : 'N',
          id === 'velocity' ? largest.speed : largest.force,
        ),
      )}
      ${row(
        html`<span class="arrow"><span class="tag">a</span> Acceleration</span>`,
        vectors.acceleration,
        'm/s²',
        largest.force / lab.simulated.state.parameters.mass!,
      )}
    </tbody>
  </table>`
}

function frictionLine({ runner, largest }: Looked, forces: Forces) {
  const text = frictionText(runner.trajectory.experiment, forces, largest.force)
  if (!text) return nothing
  // The index of μ is set as one.
  const [before, after] = text.split('μk')
  const set = after === undefined ? text : html`${before}μ<sub>k</sub>${after}`
  return html`<p class="friction-line">${set}</p>`
}
