import { simulate } from '../../physics/index.ts'
import { initialValues } from './control.ts'
import type { Control } from './control.ts'
import type { Figure } from './figure.ts'

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
  return Number((ROOM + rows * ROW + readings * READINGS + LINES[width] * LINE).toFixed(3))
}

/** A choice is one row; on a narrow page, its name and as many as its buttons take. */
function rowsOf(control: Control, narrow: boolean): number {
  // With small words beside it that take a second line on a narrow page.
  if (control.type === 'switch') return narrow ? 1.1 : 1
  if (control.type !== 'choice' || !narrow) return 1
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
