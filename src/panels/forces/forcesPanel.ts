import { html, nothing } from 'lit'
import type { ReactiveControllerHost } from 'lit'
import { dot, length } from '../../physics/index.ts'
import type { ResolvedExperiment, Vector } from '../../physics/index.ts'
import { fixed, plain, raw } from '../../chart/numbers.ts'
import type { PictureForces } from '../../view/picture.ts'
import { viewOf } from '../../view/scenes.ts'
import type { LabView } from '../../lab/labView.ts'
import { atNow } from '../../lab/playback/atNow.ts'
import { arrowNames, lookedAt, pictureForces } from './forcesPicture.ts'
import type { BlockForces, Looked } from './forcesPicture.ts'

/** Whether a lab shows forces: not at first. It is remembered as long as the page is. */
export class ForcesSwitch {
  private shown = false

  constructor(private readonly lab: LabView & ReactiveControllerHost) {}

  /** Those of the selected runner, for the picture. */
  vectors(): PictureForces | undefined {
    return this.shown ? pictureForces(this.lab) : undefined
  }

  /** The switch, and the legend of the forces. */
  panel() {
    return forcesPanel(this.lab, this.shown, (shown) => {
      this.shown = shown
      this.lab.requestUpdate()
    })
  }
}

/** The switch for the forces, and while it is on a legend of the numbers that the arrows are drawn from. */
function forcesPanel(lab: LabView, shown: boolean, show: (shown: boolean) => void) {
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
    const { outcome, abandoned } = runner.trajectory
    const why = abandoned
      ? 'The run could not keep to its tolerance'
      : outcome.kind === 'diverged'
        ? 'The run has blown up'
        : 'The block has left the track'
    return html`<p>${why}: no forces are computed any more.</p>`
  }
  return html`<div class="forces-body">
    ${table(lab, looked, forces)} ${frictionLine(looked, forces)}
  </div>`
}

function table(lab: LabView, { largest }: Looked, { vectors, velocity }: BlockForces) {
  const { scene } = lab.simulated
  const arrow = viewOf(scene).falls ? '↓' : scene.facing > 0 ? '→' : '←'
  const row = (name: unknown, value: Vector, unit: string, most: number) =>
    html`<tr>
      <th scope="row">${name}<span class="unit-beside" aria-hidden="true">, ${unit}</span></th>
      ${[length(value), dot(value, vectors.along), dot(value, vectors.across)].map(
        (each) =>
          html`<td title="${raw(each)} ${unit}">
            ${quantity(each, most)}<span class="unit">&#8239;${unit}</span>
          </td>`,
      )}
    </tr>`
  return html`<table>
    <thead>
      <tr>
        <td></td>
        <th scope="col">Size</th>
        <th scope="col" title="In the direction of increasing s">
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

function frictionLine({ runner, largest }: Looked, forces: BlockForces) {
  const text = frictionText(runner.trajectory.experiment, forces, largest.force)
  if (!text) return nothing
  // The index of μ is set as one.
  const [before, after] = text.split('μk')
  const set = after === undefined ? text : html`${before}μ<sub>k</sub>${after}`
  return html`<p class="friction-line">${set}</p>`
}

/** A number with as many decimals as the largest of its kind makes worth reading, so that it keeps its width. */
export function quantity(value: number, largest: number): string {
  const size = Math.max(largest, Math.abs(value))
  if (!(size < 1e5) || (size > 0 && size < 0.01)) return plain(rounded(value, size))
  const decimals = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 1 ? 2 : 4
  return fixed(value, decimals)
}

/** Rounds to 0 what is negligible beside the largest. */
function rounded(value: number, largest: number): number {
  return Math.abs(value) < 1e-9 * largest ? 0 : value
}

/** What friction does, and why it has this size; empty in a scene without friction. */
export function frictionText(
  { parameters, stopping }: Pick<ResolvedExperiment, 'parameters' | 'stopping'>,
  { vectors }: BlockForces,
  largest: number,
): string {
  const { muStatic, muKinetic } = parameters
  if (muStatic === undefined || muKinetic === undefined) return ''
  const { friction, normal } = vectors
  const newtons = (value: number) => `${quantity(value, largest)}\u202fN`
  const size = newtons(length(friction))
  if (vectors.frictionKind === 'held') {
    const most = muStatic * length(normal)
    const does = 'beltSpeed' in parameters ? 'carries it along' : 'holds it'
    return `Static friction ${does}: ${size} of at most ${newtons(most)}.`
  }
  if (vectors.frictionKind === 'none')
    return muStatic + muKinetic > 0
      ? `No friction at v = ${'beltSpeed' in parameters ? 'u' : '0'}: the naive rule knows only the friction of sliding.`
      : 'No friction: μ is 0.'
  const product = `μk N = ${plain(muKinetic)} × ${newtons(length(normal))}`
  const rule =
    stopping === 'naive' ? ' The naive rule knows no other, so nothing holds a block.' : ''
  return `Kinetic friction: ${product} = ${size}.${rule}`
}
