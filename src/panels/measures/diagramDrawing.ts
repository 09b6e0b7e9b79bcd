import { html, nothing, svg } from 'lit'
import { decadeText } from '../../chart/magnitudes.ts'
import { round, svgMark } from '../../ui/runnerMark.ts'
import type { DiagramLayout, Drawn, DiagramSpot } from './diagramLayout.ts'
import type { CostKind } from './points.ts'

/** Drawn stronger, and named: metres, millimetres, micrometres … */
const isUnit = (exponent: number) => exponent % 3 === 0

/** The diagram as a picture. What it says in words stands beside it. */
export function diagramDrawing(
  layout: DiagramLayout,
  kind: CostKind,
  chosen: DiagramSpot | undefined,
) {
  const { width, height } = layout
  return html`<svg
    width=${width}
    height=${height}
    viewBox="0 0 ${width} ${height}"
    aria-hidden="true"
  >
    ${grid(layout, kind)} ${frontierLine(layout)}
    ${layout.drawn.map((drawn) => curve(drawn, chosen))} ${layout.rings.map(ring)}
    ${layout.named ? layout.drawn.map((drawn) => label(layout, drawn)) : nothing}
    ${chosen ? cross(layout, chosen) : nothing}
  </svg>`
}

function grid(layout: DiagramLayout, kind: CostKind) {
  const { left, right, top, bottom, across, up, rounding, failed } = layout
  const every = up.decades.length <= 6
  return svg`<g class="grid">
    ${rounding === undefined ? nothing : svg`<rect class="band" x=${left} y=${rounding} width=${right - left} height=${bottom - rounding} />`}
    ${up.decades.map((exponent) => {
      const y = round(up.at(10 ** exponent))
      if (rounding !== undefined && y > rounding - 6) return nothing
      const strong = isUnit(exponent) || every
      return svg`<line class=${strong ? 'guide' : ''} x1=${left} x2=${right} y1=${y} y2=${y} />
        ${strong ? svg`<text class="tick" x=${left - 8} y=${y + 4} text-anchor="end">${decadeText(exponent)}</text>` : nothing}`
    })}
    ${across.decades.map((exponent) => {
      const x = round(across.at(10 ** exponent))
      return svg`<line x1=${x} x2=${x} y1=${top} y2=${bottom} />
        <text class="tick" x=${x} y=${bottom + 17} text-anchor="middle">${kind.text(10 ** exponent)}</text>`
    })}
    <line class="axis" x1=${left} x2=${right} y1=${bottom} y2=${bottom} />
    <text class="tick" x=${(left + right) / 2} y=${bottom + 36} text-anchor="middle">${kind.axis}</text>
    ${rounding === undefined ? nothing : svg`<line class="guide" x1=${left} x2=${right} y1=${rounding} y2=${rounding} /><text class="tick" x=${left - 8} y=${(rounding + bottom) / 2 + 4} text-anchor="end">rounding</text>`}
    ${failed === undefined ? nothing : svg`<text class="tick" x=${left - 8} y=${failed - 10} text-anchor="end">no end</text>`}
  </g>`
}

function frontierLine({ frontier }: DiagramLayout) {
  if (frontier.length === 0) return nothing
  const path = frontier.map(({ x, y }, i) => `${i === 0 ? 'M' : 'L'}${round(x)} ${round(y)}`)
  return svg`<path class="frontier" d=${frontier.length > 1 ? path.join('') : `${path[0]!}h0.01`} />`
}

function curve({ curve, spots }: Drawn, chosen: DiagramSpot | undefined) {
  const { paletteIndex, method, by } = curve
  let pen = false
  const path = spots.map(({ x, y, point }) => {
    const text = point.whole ? `${pen ? 'L' : 'M'}${round(x)} ${round(y)}` : ''
    pen = point.whole
    return text
  })
  return svg`<g class="curve" data-method=${method} data-by=${by} .style="--look: var(--runner-${paletteIndex})" ?data-chosen=${chosen?.point.method === method}>
    <path class="line" d=${path.join('')} />
    ${spots.map(({ x, y, point }) => (point.whole ? svgMark(paletteIndex, x, y, by === 'rate' ? 4.2 : 3) : svg`<path class="failure" d="M${round(x - 3.5)} ${round(y - 3.5)}l7 7m0-7l-7 7" />`))}
  </g>`
}

/**
 * A ring around a runner’s point. Its mark is at a place of its own, so that of several rings in one each can be told.
 */
function ring({ x, y, point }: DiagramSpot) {
  const { paletteIndex, apart } = point.runner!
  const turn = ((1 + paletteIndex) * Math.PI) / 4
  const [across, up] = [8 * Math.cos(turn), 8 * Math.sin(turn)]
  return svg`<g class="ring" ?data-apart=${apart} .style="--look: var(--runner-${paletteIndex})">
    <circle class="halo" cx=${round(x)} cy=${round(y)} r="8" /><circle cx=${round(x)} cy=${round(y)} r="8" />
    ${svgMark(paletteIndex, x + across, y - up, 5)}
  </g>`
}

function label({ right }: DiagramLayout, { curve, spots, labelY }: Drawn) {
  if (labelY === undefined) return nothing
  const last = spots.at(-1)
  const x = right + 16
  return svg`<g class="name" .style="--look: var(--runner-${curve.paletteIndex})">
    ${last ? svg`<path class="lead" d="M${round(last.x + 7)} ${round(last.y)}L${right + 7} ${round(labelY)}" />` : nothing}
    ${svgMark(curve.paletteIndex, x, labelY, 4.6)}
    <text x=${x + 11} y=${labelY + 4}>${curve.label}<tspan class="order" dx="6">${short(curve.order)}</tspan></text>
  </g>`
}

/** There is no room for more beside a name. */
function short(order: string): string {
  return order.startsWith('order') && /\d/.test(order)
    ? order
    : order === 'exact to rounding'
      ? 'exact'
      : '–'
}

function cross({ left, bottom, failed, top }: DiagramLayout, { x, y }: DiagramSpot) {
  return svg`<g class="cross">
    <path d="M${left} ${round(y)}H${round(x)}M${round(x)} ${failed === undefined ? top : top - 26}V${bottom}" />
    <circle cx=${round(x)} cy=${round(y)} r="9" />
  </g>`
}
