import { meaningOf, processColumns } from './columns.ts'
import type { Meaning } from './columns.ts'
import { cellsOf, linesOf, readCell, separatorOf } from './lines.ts'
import type { Line } from './lines.ts'
import { Series } from './series.ts'
import type { Candidate } from './series.ts'

/** Headings stand this far down at most: tools put a few lines about the machine above them [lines]. */
const DEEPEST = 60
/** The processes with the most rows; what else presented a frame now and then is not offered. */
const MOST_PROCESSES = 12
/** What Afterburner writes before the columns' names, and before a row of values. */
const AFTERBURNER = { headings: '02', values: '80' }

/** Where a table's columns are named. */
export interface Headings {
  readonly line: Line
  readonly separator: string
  readonly names: readonly string[]
}

/** The line that names a column of frame times, or where none does of instants. */
export function findHeadings(text: string): Headings | undefined {
  let clock: Headings | undefined
  let seen = 0
  for (const line of linesOf(text)) {
    if (++seen > DEEPEST) break
    const separator = separatorOf(line.text)
    const names = cellsOf(line.text, separator)
    const found = names.map(meaningOf).filter((each) => each !== undefined)
    if (found.some(({ isClock }) => !isClock)) return { line, separator, names }
    if (found.length > 0) clock ??= { line, separator, names }
  }
  return clock
}

/** Reads a table; yields how much of the text is read, 0 … 1. */
export function* readTable(
  text: string,
  { line: heading, separator, names }: Headings,
): Generator<number, Candidate[]> {
  const columns = names.flatMap((name, column) => {
    const meaning = meaningOf(name)
    return meaning ? [{ name, column, meaning }] : []
  })
  const whose = processColumns(names)
  const isAfterburner = names[0] === AFTERBURNER.headings
  const groups = new Map<string, { about: string[]; series: Series[] }>()
  let count = 0
  for (const { text: row, number, end } of linesOf(text, heading.end, heading.number + 1)) {
    if (++count % 500 === 0) yield end / text.length
    const cells = cellsOf(row, separator)
    if (isAfterburner && cells[0] !== AFTERBURNER.values) continue
    const about = whose.map((column) => cells[column] ?? '')
    const key = about.join('\n')
    let group = groups.get(key)
    if (!group) groups.set(key, (group = { about, series: columns.map(() => new Series()) }))
    columns.forEach(({ column }, i) => group.series[i]!.add(cells[column] ?? '', number))
  }
  const most = [...groups.values()]
    .sort((a, b) => b.series[0]!.rows - a.series[0]!.rows)
    .slice(0, MOST_PROCESSES)
  const candidates: Candidate[] = []
  for (const { about, series } of most)
    for (const { name, meaning, i } of byRank(columns))
      candidates.push(yield* series[i]!.candidate(name, processName(about, most), meaning))
  return candidates
}

function byRank(columns: readonly { name: string; meaning: Meaning }[]) {
  return columns
    .map(({ name, meaning }, i) => ({ name, meaning, i }))
    .sort((a, b) => a.meaning.rank - b.meaning.rank)
}

/** As much of what is known of a process as it takes to tell it from the others. */
function processName(about: readonly string[], all: readonly { about: readonly string[] }[]) {
  const length = about.findIndex(
    (_, i) =>
      all.filter((other) => about.slice(0, i + 1).every((each, n) => each === other.about[n]))
        .length === 1,
  )
  return (length < 0 ? about : about.slice(0, length + 1)).join(', ')
}

/** Whether a line looks like the names of columns rather than like numbers. */
export function namesColumns(line: string): boolean {
  const cells = cellsOf(line, separatorOf(line))
  return cells.length > 1 && cells.filter((cell) => Number.isNaN(readCell(cell))).length > 1
}
