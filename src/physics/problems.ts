/** One thing that is wrong with an experiment. */
export interface Problem {
  /** The path, as `frames.fps`; empty for the experiment itself. */
  path: string
  /** The given value and what is allowed. */
  message: string
}

/** The most problems that a message lists; it only counts the rest. */
export const MOST_SHOWN = 20

/** Thrown for an experiment that can't be run; its message is for people and names every problem. */
export class ExperimentError extends Error {
  readonly problems: readonly Problem[]

  constructor(problems: readonly Problem[]) {
    const lines = problems
      .slice(0, MOST_SHOWN)
      .map(({ path, message }) => `${path || 'The experiment'}: ${message}`)
    if (problems.length > MOST_SHOWN) lines.push(`… and ${problems.length - MOST_SHOWN} more.`)
    super(lines.join('\n'))
    this.name = 'ExperimentError'
    this.problems = problems
  }
}

const LONGEST = 40

/** A short text for any value in a message. */
export function show(value: unknown): string {
  try {
    return shown(value)
  } catch {
    // A Proxy may throw anything.
    return 'something unreadable'
  }
}

function shown(value: unknown): string {
  if (typeof value === 'string') return `"${shorten(value)}"`
  if (Array.isArray(value)) return `a list of ${value.length}`
  if (value instanceof Error) return `the error "${shorten(value.message)}"`
  if (typeof value === 'object' && value !== null) return 'an object'
  if (typeof value === 'function') return 'a function'
  if (Object.is(value, -0)) return '-0'
  return shorten(String(value))
}

/** Shortens a text to fit in a message, by whole characters. */
export function shorten(text: string): string {
  // A character takes one or two code units.
  const start = Array.from(text.slice(0, 2 * LONGEST + 2))
  return start.length > LONGEST ? `${start.slice(0, LONGEST).join('')}…` : text
}

/** The known name that is closest to a written one, if any is close. */
export function nearestName(written: string, known: readonly string[]): string | undefined {
  if (written.length > LONGEST) return undefined
  let best: string | undefined
  let fewest = Math.max(2, written.length / 2) + 1
  for (const name of known) {
    const wanted = name.toLowerCase()
    // A written part of a name counts as one edit.
    const isPart = written.length > 2 && wanted.includes(written.toLowerCase())
    const edits = isPart ? 1 : editDistance(written.toLowerCase(), wanted)
    if (edits < fewest) {
      fewest = edits
      best = name
    }
  }
  return best
}

/** The insertions, deletions and replacements that turn one word into the other (Wagner and Fischer, 1974). */
function editDistance(a: string, b: string): number {
  let above = Array.from({ length: b.length + 1 }, (_, j) => j)
  for (let i = 1; i <= a.length; i++) {
    const row = [i]
    for (let j = 1; j <= b.length; j++)
      row.push(
        Math.min(row[j - 1]! + 1, above[j]! + 1, above[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1)),
      )
    above = row
  }
  return above[b.length]!
}
