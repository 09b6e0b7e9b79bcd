import { linesOf } from './lines.ts'
import { Series } from './series.ts'

/** Numbers with blanks, commas, semicolons or tabs between them; yields how much of the text is read, 0 … 1. */
export function* readList(text: string): Generator<number, Series> {
  const series = new Series()
  const separators = hasDecimalCommas(text) ? /[\s;]+/ : /[\s,;]+/
  let count = 0
  for (const { text: line, number, end } of linesOf(text)) {
    for (const item of line.split(separators)) {
      if (item !== '') series.add(item, number)
      if (++count % 2000 === 0) yield end / text.length
    }
  }
  return series
}

/**
 * Judged by the beginning: every number has one comma between digits, none a point, and something else is between them.
 */
function hasDecimalCommas(text: string): boolean {
  const items = text
    .slice(0, 5000)
    .trim()
    .split(/[\s;]+/)
  // The last may be cut in two.
  const whole = items.length > 2 ? items.slice(0, -1) : items
  const decimal = whole.filter((item) => /^-?\d+,\d+$/.test(item))
  return (
    items.length > 1 && decimal.length > 0.5 * whole.length && !/\d\.\d/.test(text.slice(0, 5000))
  )
}
