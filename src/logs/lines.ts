/** What stands between the cells of a line: semicolons or tabs where there are any, since commas may be decimal then. */
export function separatorOf(line: string): string {
  return [';', '\t', ','].find((each) => line.includes(each)) ?? ''
}

/** The cells of a line, without the blanks and quotes around them. */
export function cellsOf(line: string, separator: string): string[] {
  if (separator === '') return [bare(line)]
  if (!line.includes('"')) return line.split(separator).map((cell) => cell.trim())
  const cells: string[] = []
  let from = 0
  let isQuoted = false
  for (let i = 0; i <= line.length; i++) {
    if (line[i] === '"') isQuoted = !isQuoted
    if (i < line.length && (isQuoted || line[i] !== separator)) continue
    cells.push(bare(line.slice(from, i)))
    from = i + 1
  }
  return cells
}

function bare(cell: string): string {
  const text = cell.trim()
  return /^".*"$/s.test(text) ? text.slice(1, -1).replaceAll('""', '"').trim() : text
}

const decimal = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?$/i

/** The number in a cell, with a decimal point or a decimal comma; NaN where it is none. */
export function readCell(text: string): number {
  const point = text.includes(',') ? pointed(text) : text
  return decimal.test(point) ? Number(point) : NaN
}

/** With a point where the decimal comma was, and without the signs that separate thousands: “1.234,5” is 1234.5. */
function pointed(text: string): string {
  const last = Math.max(text.lastIndexOf(','), text.lastIndexOf('.'))
  return `${text.slice(0, last).replace(/[.,]/g, '')}.${text.slice(last + 1)}`
}

/** A line of a text, by its number counted from 1. */
export interface Line {
  readonly text: string
  readonly number: number
  /** Where the next line begins. */
  readonly end: number
}

/** The lines that say something: neither blank nor a comment. */
export function* linesOf(text: string, start = 0, first = 1): Generator<Line> {
  let number = first
  for (let from = start; from < text.length; number++) {
    const at = text.indexOf('\n', from)
    const end = at < 0 ? text.length : at
    const line = text.slice(from, end).trim()
    from = end + 1
    if (line !== '' && !/^(#|\/\/)/.test(line))
      yield { text: line, number, end: Math.min(from, text.length) }
  }
}
