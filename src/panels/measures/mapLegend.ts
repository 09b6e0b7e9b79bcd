import { html, nothing } from 'lit'
import { REFERENCE_RATE, ROUNDING } from '../../measure/index.ts'
import { HIGHEST } from './mapCells.ts'
import type { MapCells } from './mapCells.ts'
import { rampGradient } from './ramp.ts'
import { metresText } from '../../chart/scale.ts'

/** What the colours and hatchings of a map mean; only those that there are. */
export function mapLegend(cells: MapCells, dark: boolean, limit: string) {
  const { request } = cells
  const { low, high } = cells.decades()
  const every = Math.ceil((high - low) / 6)
  const ticks = Array.from({ length: high - low + 1 }, (_, i) => low + i)
  const has = (kind: string) => cells.count((cell) => cell.kind === kind) > 0
  const swatch = (kind: string, text: string) =>
    html`<li><span class="swatch" data-kind=${kind}></span> ${text}</li>`
  return html`<div class="map-legend">
    <div class="ramp">
      <span
        >${request.of === 'error' ? 'largest error of the run' : `distance from the end at ${REFERENCE_RATE} fps`}</span
      >
      <div class="bar" .style="background: ${rampGradient(dark)}"></div>
      <div class="ramp-ticks" aria-hidden="true">
        ${ticks.map(
          (exponent, i) =>
            html`<span .style="left: ${(100 * i) / (ticks.length - 1)}%"
              >${(high - exponent) % every === 0 ? `${exponent === HIGHEST ? '≥\u2009' : ''}${metresText(exponent)}` : nothing}</span
            >`,
        )}
      </div>
    </div>
    <ul class="key">
      ${cells.count(({ value }) => value < ROUNDING) > 0 ? swatch('rounding', '0 (to rounding)') : nothing}
      ${has('left-the-track') ? swatch('left-the-track', 'left the track') : nothing}
      ${has('diverged') ? swatch('diverged', 'blew up') : nothing}
      ${has('refused') ? swatch('refused', 'can’t be run') : nothing}
      ${limit ? html`<li><span class="limit-line"></span> ${limit}</li>` : nothing}
    </ul>
  </div>`
}
