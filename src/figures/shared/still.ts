import { simulate } from '../../physics/index.ts'
import { clipTo } from '../../chart/graph.ts'
import type { Palette } from '../../view/palette.ts'
import { initialValues } from './control.ts'
import type { Control } from './control.ts'
import { WIDE } from './figure.ts'
import type { Figure, View } from './figure.ts'

/** What a figure shows when it opens. */
export function openingView(figure: Figure): View {
  const values = initialValues(figure.controls)
  const runs = figure.experiments(values).map(simulate)
  return { values, runs, time: figure.opensAtStart ? 0 : (figure.duration?.(values) ?? 0) }
}

/** The height of a figure's pictures together at a width [px]. */
export function heightOf({ panels }: Pick<Figure, 'panels'>, width: number): number {
  return panels.reduce(
    (sum, { shape }) => sum + width * (width < WIDE ? shape.narrow : shape.wide),
    0,
  )
}

/** Draws a figure as it opens, all of its pictures one under the other, from the context's origin. */
export function drawStill(
  context: CanvasRenderingContext2D,
  figure: Figure,
  { width, palette }: { width: number; palette: Palette },
): void {
  const view = openingView(figure)
  context.save()
  for (const [i, panel] of figure.panels.entries()) {
    const height = heightOf({ panels: [panel] }, width)
    context.save()
    // In the page each has a canvas of its own; here one must not cover the one above.
    if (i > 0) clipTo(context, { left: 0, right: width, top: 0, bottom: height })
    panel.draw({ context, width, height, palette }, view)
    context.restore()
    context.translate(0, height)
  }
  context.restore()
}

/*
 * How much room a figure takes before it is there, so that nothing on the page moves when it comes alive: the picture
 * by its shape, what stands below it by rows of known height. figure.css reads these custom properties.
 */

/** A row of a control, of readings, of the transport, and a line of text [rem]. */
const ROW = 2.75
const READINGS = 3.25
const LINE = 1.375
/** Above, between and below [rem]. */
const ROOM = 2.25

/** The lines that the longest sentence of a figure takes in a wide figure, and in a narrow one. */
const LINES = { wide: 3, narrow: 5 }
/** The letters that a line of advice holds. */
const LETTERS = { wide: 105, narrow: 49 }

/** The figure's room as the text of a style attribute; the still at build time and the live figure have the same. */
export function frameOf(figure: Figure): string {
  const room = (width: 'wide' | 'narrow') => {
    const shape = figure.panels.reduce((sum, panel) => sum + panel.shape[width], 0)
    const hosted = figure.hosted ? `; --hosted-${width}: ${figure.hosted.room[width]}rem` : ''
    return `--shape-${width}: ${Number((1 / shape).toFixed(4))}; --below-${width}: ${below(figure, width)}rem${hosted}`
  }
  return `${room('wide')}; ${room('narrow')}`
}

function below(figure: Figure, width: 'wide' | 'narrow'): number {
  const shown = Object.values(figure.controls).filter(({ hidden }) => !hidden)
  const narrow = width === 'narrow'
  const sliders = shown.filter(({ type }) => type === 'number').length
  const others = shown.filter(({ type }) => type !== 'number')
  const rows =
    (narrow ? sliders : Math.ceil(sliders / 2)) +
    others.reduce((sum, control) => sum + rowsOf(control, narrow), 0) +
    (figure.duration || figure.action ? 1 : 0)
  const count = readingCount(figure)
  const readings = narrow ? Math.ceil(count / 2) : Math.min(1, count)
  const advice = figure.advice ? Math.ceil(figure.advice.longest / LETTERS[width]) : 0
  const lines = LINES[width] + advice
  return Number((ROOM + rows * ROW + readings * READINGS + lines * LINE).toFixed(3))
}

/** A choice is one row; on a narrow page, its name and as many as its buttons take. */
function rowsOf(control: Control, narrow: boolean): number {
  // With small words beside it that take a second line on a narrow page.
  if (control.type === 'switch') return narrow ? 1.1 : 1
  if (control.type !== 'choice' || control.menu || !narrow) return 1
  return 0.5 + 0.85 * linesOf(control.options.map(({ label }) => 7.2 * label.length + 30))
}

/** How many lines boxes of such widths take in a column of a phone [px]. */
function linesOf(widths: readonly number[]): number {
  let lines = 1
  let used = 0
  for (const width of widths) {
    if (used + width > 300) {
      lines++
      used = 0
    }
    used += width
  }
  return lines
}

function readingCount({ controls, experiments, readings }: Figure): number {
  if (!readings) return 0
  const values = initialValues(controls)
  return readings(values, experiments(values).map(simulate), 0).length
}
