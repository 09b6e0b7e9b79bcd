import { html, nothing } from 'lit'
import type { Simulated } from '../../lab/state/simulation.ts'
import { EXACT } from './curves.ts'
import type { PlotKind } from './kinds.ts'
import type { Reading } from './readings.ts'

/**
 * What each visible runner shows at the cursor. Each has its place, whatever stands there: nothing moves when values come
 * and go.
 */
export function plotValues(
  kind: PlotKind,
  { visible }: Simulated,
  readings: readonly Reading[],
  pointed: (event: PointerEvent) => void,
) {
  const looks = [
    ...visible.map(({ state, name }) => ({ look: state.look, name })),
    ...(kind.of.ofExact ? [{ look: EXACT, name: 'exact' }] : []),
  ]
  return html`<ul class="values" data-pair=${kind.over ? '' : nothing} @pointerover=${pointed}>
    ${looks.map(({ look, name }, i) => {
      const reading = readings[i]
      return html`<li data-index=${i}>
        ${
          look === EXACT
            ? html`<span class="dash" aria-hidden="true"></span>`
            : html`<runner-mark .look=${look}></runner-mark>`
        }<span class="visually-hidden">${name}</span>
        <span class="value">${reading?.text ?? '–'}</span>
      </li>`
    })}
  </ul>`
}
