import { html, nothing, svg } from 'lit'
import { mappedExperiment, stableRate } from '../../measure/index.ts'
import type { MapRequest } from '../../measure/index.ts'
import { drawnBetween, logScale, roundTicks } from '../../chart/axis.ts'
import { plain } from '../../chart/numbers.ts'
import { round, svgMark } from '../../ui/runnerMark.ts'
import { mappedOption } from './mapWords.ts'

/** Where a map's image lies in its picture [px]. */
export interface MapFrame {
  readonly width: number
  readonly height: number
  readonly left: number
  readonly top: number
  readonly right: number
  readonly bottom: number
}

/** A place in a map, by column and row; between two of them it is a fraction. */
export interface MapPlace {
  readonly column: number
  readonly row: number
}

const rates = [5, 10, 15, 24, 30, 60, 120, 144, 240]
/** Where these stand close together, on a phone. */
const fewRates = [5, 10, 30, 60, 120, 240]

export function mapFrame(width: number, height: number): MapFrame {
  return { width, height, left: 58, top: 10, right: width - 12, bottom: height - 44 }
}

/** Axes, the stability limit, where the lab stands, and the cross hair: everything over the image. */
export function mapDrawing(
  request: MapRequest,
  frame: MapFrame,
  here: (MapPlace & { paletteIndex: number }) | undefined,
  cross: MapPlace | undefined,
) {
  const { width, height, left, right, top, bottom } = frame
  const option = mappedOption(request)
  const shown = right - left < 420 ? fewRates : rates
  const { x: xOf, y: yOf } = scales(request, frame)
  const ticks = roundTicks(request.from, request.to, 7).values
  return html`<svg
    width=${width}
    height=${height}
    viewBox="0 0 ${width} ${height}"
    aria-hidden="true"
  >
    <g class="grid">
      ${shown.map((fps) => {
        const x = round(xOf(fps))
        return svg`<path class="axis" d="M${x} ${bottom}v5" />
          <text class="tick" x=${x} y=${bottom + 18} text-anchor="middle">${fps}</text>`
      })}
      ${ticks.map((value) => {
        const y = round(yOf(value))
        return svg`<path class="axis" d="M${left} ${y}h-5" />
          <text class="tick" x=${left - 8} y=${y + 4} text-anchor="end">${plain(value)}</text>`
      })}
      <rect class="frame" x=${left} y=${top} width=${right - left} height=${bottom - top} />
      <text class="tick" x=${(left + right) / 2} y=${bottom + 36} text-anchor="middle">
        frames a second
      </text>
      <text
        class="tick"
        transform="translate(14 ${(top + bottom) / 2}) rotate(-90)"
        text-anchor="middle"
      >
        ${option.label.toLowerCase()}${option.unit ? ` [${option.unit}]` : ''}
      </text>
    </g>
    ${limit(request, frame)}
    ${here ? svg`<g class="here" .style="--look: var(--runner-${here.paletteIndex})">${svgMark(here.paletteIndex, columnX(request, frame, here.column), rowY(request, frame, here.row), 6)}</g>` : nothing}
    ${cross ? crossHair(request, frame, cross) : nothing}
  </svg>`
}

/** Where a frame rate and a parameter's value are in the picture [px]. */
function scales(
  { slowest, fastest, from, to }: MapRequest,
  { left, right, top, bottom }: Omit<MapFrame, 'width' | 'height'>,
): { x: (fps: number) => number; y: (value: number) => number } {
  return {
    x: logScale(slowest, fastest, left, right).at,
    y: drawnBetween({ from, to }, bottom, top),
  }
}

/** The place of a frame rate and a parameter's value in a map, if it is there. */
export function mapPlaceOf(request: MapRequest, fps: number, value: number): MapPlace | undefined {
  const { columns, rows } = request
  const { x, y } = scales(request, { left: 0, right: columns, top: rows, bottom: 0 })
  const column = x(fps) - 0.5
  const row = y(value) - 0.5
  const inside = column >= -0.5 && column <= columns - 0.5 && row >= -0.5 && row <= rows - 0.5
  return inside ? { column, row } : undefined
}

/** The cell under a point of the picture, if there is one. */
export function cellUnder(
  { columns, rows }: MapRequest,
  { left, right, top, bottom }: MapFrame,
  x: number,
  y: number,
): MapPlace | undefined {
  const column = Math.floor((columns * (x - left)) / (right - left))
  const row = Math.floor((rows * (bottom - y)) / (bottom - top))
  return column >= 0 && column < columns && row >= 0 && row < rows ? { column, row } : undefined
}

/** Where the middle of a column is, and that of a row [px]. */
function columnX({ columns }: MapRequest, { left, right }: MapFrame, column: number): number {
  return left + ((right - left) * (column + 0.5)) / columns
}

function rowY({ rows }: MapRequest, { top, bottom }: MapFrame, row: number): number {
  return bottom - ((bottom - top) * (row + 0.5)) / rows
}

/** The line to whose left theory says that runs blow up. */
function limit(request: MapRequest, frame: MapFrame) {
  const points: string[] = []
  for (let row = 0; row < request.rows; row++) {
    const rate = stableRate(mappedExperiment(request, 0, row))
    if (rate === undefined || !(rate >= request.slowest && rate <= request.fastest)) continue
    points.push(`${round(scales(request, frame).x(rate))} ${round(rowY(request, frame, row))}`)
  }
  if (points.length < 2) return nothing
  const path = `M${points.join('L')}`
  return svg`<g class="limit"><path class="halo" d=${path} /><path d=${path} /></g>`
}

function crossHair(request: MapRequest, frame: MapFrame, { column, row }: MapPlace) {
  const x = round(columnX(request, frame, column))
  const y = round(rowY(request, frame, row))
  const { left, right, top, bottom } = frame
  const path = `M${left} ${y}H${x - 5}M${x + 5} ${y}H${right}M${x} ${top}V${y - 5}M${x} ${y + 5}V${bottom}`
  return svg`<g class="cross"><path class="halo" d=${path} /><path d=${path} />
    <rect x=${x - 5} y=${y - 5} width="10" height="10" /></g>`
}
