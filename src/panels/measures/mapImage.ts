import { html, nothing } from 'lit'
import type { LitElement } from 'lit'
import { REFERENCE_RATE } from '../../measure/index.ts'
import type { CellKind } from '../../measure/index.ts'
import { clamp } from '../../chart/geometry.ts'
import { decadeText } from '../../chart/magnitudes.ts'
import { PaletteReader, mix } from '../../view/palette.ts'
import type { Palette, Rgb } from '../../view/palette.ts'
import { onThemeChange } from '../../ui/theme.ts'
import { HIGHEST } from './mapCells.ts'
import type { MapCells } from './mapCells.ts'

/** Viridis (Smith and van der Walt, 2015): even to the eye, and to eyes that see fewer colours. */
const stops: readonly Rgb[] = [
  [68, 1, 84],
  [70, 50, 126],
  [54, 92, 141],
  [39, 127, 142],
  [31, 161, 135],
  [74, 193, 109],
  [160, 218, 57],
  [253, 231, 37],
]

/** The colour at a part of the ramp, 0 … 1, from the paper's side: pale first on light paper, dark first on dark. */
export function rampColour(part: number, dark: boolean): Rgb {
  const place = clamp(dark ? part : 1 - part, 0, 1) * (stops.length - 1)
  const below = Math.min(stops.length - 2, Math.floor(place))
  return mix(stops[below]!, stops[below + 1]!, place - below)
}

/** The same ramp for a legend. */
function rampGradient(dark: boolean): string {
  const colours = stops.map((_, i) => `rgb(${rampColour(i / (stops.length - 1), dark).join(' ')})`)
  return `linear-gradient(to right, ${colours.join(', ')})`
}

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
              >${(high - exponent) % every === 0 ? `${exponent === HIGHEST ? '≥\u202f' : ''}${decadeText(exponent)}` : nothing}</span
            >`,
        )}
      </div>
    </div>
    <ul class="key">
      ${cells.count(({ value }) => value === 0) > 0 ? swatch('rounding', '0 (to rounding)') : nothing}
      ${has('left-the-track') ? swatch('left-the-track', 'left the track') : nothing}
      ${has('diverged') ? swatch('diverged', 'blew up') : nothing}
      ${has('different') ? swatch('different', `not as at ${REFERENCE_RATE} fps`) : nothing}
      ${has('refused') ? swatch('refused', 'can’t be run') : nothing}
      ${limit ? html`<li><span class="limit-line"></span> ${limit}</li>` : nothing}
    </ul>
  </div>`
}

/** An element with a map in its canvas. */
interface Host extends LitElement {
  readonly cells: MapCells
}

/** Keeps the map of an element painted: again whenever its cells or the page's colours are others. */
export function keepPainted(host: Host): void {
  const colours = new PaletteReader(host)
  /** What the image was painted from. */
  let painted: unknown[] = []
  let stopThemes = () => {}
  const paint = () => {
    const { cells } = host
    const canvas = host.querySelector('canvas')
    const palette = colours.read()
    const wanted = [cells, cells.version, palette]
    if (!canvas || wanted.every((each, i) => each === painted[i])) return
    painted = wanted
    paintMap(canvas, cells, palette, isDark(host))
  }
  host.addController({
    hostConnected: () => {
      stopThemes = onThemeChange(() => {
        host.requestUpdate()
        // At once: before it prints, Firefox runs no microtask.
        paint()
      })
    },
    hostDisconnected: () => stopThemes(),
    hostUpdated: paint,
  })
}

/** Whether an element is seen on a dark page. */
export function isDark(element: Element): boolean {
  return getComputedStyle(element).colorScheme === 'dark'
}

/** Paints a map, a pixel for each cell. Cells without a number are hatched, each kind in its own way. */
function paintMap(
  canvas: HTMLCanvasElement,
  cells: MapCells,
  palette: Palette,
  dark: boolean,
): void {
  const { columns, rows } = cells.request
  const { low, high } = cells.decades()
  const pen = canvas.getContext('2d')!
  const [ground, soft, sheet] = [palette.ground, palette.inkSoft, palette.sheet].map((colour) =>
    toRgb(pen, colour),
  ) as [Rgb, Rgb, Rgb]
  const colourOf = (kind: CellKind, value: number, column: number, row: number): Rgb => {
    switch (kind) {
      case 'measured':
        return value === 0 ? sheet : rampColour((Math.log10(value) - low) / (high - low), dark)
      case 'left-the-track':
        return (column + row) % 4 === 0 ? soft : ground
      case 'diverged':
        return (column - row + rows) % 4 < 2 ? soft : sheet
      case 'different':
        return (column + row) % 4 < 2 ? soft : ground
      case 'refused':
        return column % 4 === 0 && row % 4 === 0 ? soft : ground
      default:
        return ground
    }
  }
  const image = pen.createImageData(columns, rows)
  for (let row = 0; row < rows; row++)
    for (let column = 0; column < columns; column++) {
      const { kind, value } = cells.cell(column, row)
      const colour = colourOf(kind, value, column, row)
      const at = 4 * ((rows - 1 - row) * columns + column)
      image.data.set(colour, at)
      image.data[at + 3] = 255
    }
  pen.putImageData(image, 0, 0)
}

/** As the browser writes an opaque colour: “#1b2026”. */
function toRgb(pen: CanvasRenderingContext2D, colour: string): Rgb {
  pen.fillStyle = colour
  const hex = Number.parseInt(String(pen.fillStyle).slice(1), 16)
  return [hex >> 16, (hex >> 8) & 255, hex & 255]
}
