import { readJson } from './json.ts'
import { linesOf } from './lines.ts'
import { readList } from './list.ts'
import { LogError } from './logError.ts'
import type { Candidate } from './series.ts'
import { findHeadings, namesColumns, readTable } from './table.ts'

export { LogError } from './logError.ts'
export type { Candidate } from './series.ts'
export type { Unit } from './units.ts'

/**
 * Reads frame times from the log of a tool: PresentMon, OCAT, CapFrameX, MangoHud, FRAPS, Afterburner, a trace of Chrome, or a bare list.
 * Yields how much is read, 0 … 1, so that the caller can pause; returns what the log can be read as, the likeliest first.
 *
 * @throws LogError where no frame time can be read
 */
export function* readLog(text: string): Generator<number, Candidate[]> {
  const content = text.replace(/^\ufeff/, '')
  const first = linesOf(content).next().value as { text: string; number: number } | undefined
  if (!first) throw new LogError('There is nothing in it.')
  const all = yield* candidatesOf(content, first)
  const some = all.filter(({ durations }) => durations.length > 0)
  if (some.length > 0) return some
  const [worst] = all.flatMap(({ reasons }) => reasons)
  throw new LogError(
    worst
      ? `${worst.place}: ${worst.reason}. No row holds a frame time.`
      : `Line ${first.number}: no row with frame times follows.`,
  )
}

function* candidatesOf(
  text: string,
  first: { text: string; number: number },
): Generator<number, Candidate[]> {
  if (/^[[{]/.test(first.text)) return yield* readJson(text)
  const headings = findHeadings(text)
  if (headings) return yield* readTable(text, headings)
  if (namesColumns(first.text))
    throw new LogError(
      `Line ${first.number}: none of its columns is named as a frame time, such as FrameTime, msBetweenPresents or Time (ms).`,
    )
  const series = yield* readList(text)
  if (series.numbers < 0.5 * series.rows)
    throw new LogError(`Line ${first.number}: this is neither a table nor a list of numbers.`)
  return [yield* series.candidate('', '', { rank: 0, isClock: false })]
}
