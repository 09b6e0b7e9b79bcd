import type { LitElement } from 'lit'
import type { CellKind } from '../../measure/index.ts'
import { PaletteReader } from '../../view/palette.ts'
import type { Palette, Rgb } from '../../view/palette.ts'
import { onThemeChange } from '../../ui/theme.ts'
import type { MapCells } from './mapCells.ts'
import { rampColour } from './mapColours.ts'

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
