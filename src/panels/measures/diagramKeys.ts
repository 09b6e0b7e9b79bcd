import { html, nothing } from 'lit'
import { integrators } from '../../physics/index.ts'
import { raw } from '../../chart/numbers.ts'
import { errorText } from './diagramWords.ts'
import type { LabRunner } from './labRunners.ts'
import type { DiagramCurve } from './points.ts'

/** Which curve is whose, and of what order it turned out. Its room is known before the curves are. */
export function curveKey(curves: readonly DiagramCurve[]) {
  return html`<ul class="key curve-key">
    ${integrators.map(
      ({ id, label, colour }) =>
        html`<li>
          <runner-mark .look=${colour}></runner-mark> ${label}
          <span class="soft">${curves.find(({ method }) => method === id)?.order}</span>
        </li>`,
    )}
  </ul>`
}

/** Which ring is which runner's, with its error, or why it has none. */
export function ringKey(runners: readonly LabRunner[]) {
  return html`<ul class="key ring-key">
    <li class="soft">Rings: the lab’s runners</li>
    ${runners.map(
      ({ name, look, point, why }) =>
        html`<li title=${point ? `${raw(point.error)} m` : ''}>
          <runner-mark .look=${look}></runner-mark> ${name}
          <span class="soft">${point ? errorText(point) : `no ring: ${why}`}</span>
        </li>`,
    )}
    ${
      runners.some(({ point }) => point?.runner!.apart)
        ? html`<li class="soft">Dashed: stops or steps otherwise than the curves</li>`
        : nothing
    }
  </ul>`
}
