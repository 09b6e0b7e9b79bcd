/** One thing that is wrong with an experiment. */
export interface Problem {
  /** Where, as `frames.fps`; empty for the experiment itself. */
  path: string
  /** What was given and what is allowed. */
  message: string
}

/** So many problems a message shows; of the rest it says how many there are. */
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

/** A value as a message shows it: short, whatever it is. */
export function show(value: unknown): string {
  try {
    return shown(value)
  } catch {
    // A Proxy throws what it likes.
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

/** Text cut to what fits in a message, by whole characters. */
export function shorten(text: string): string {
  // A character takes one or two places.
  const start = Array.from(text.slice(0, 2 * LONGEST + 2))
  return start.length > LONGEST ? `${start.slice(0, LONGEST).join('')}…` : text
}

/** The known name that is nearest to what was written, if one is near. */
export function nearest(written: string, known: readonly string[]): string | undefined {
  if (written.length > LONGEST) return undefined
  let best: string | undefined
  let fewest = Math.max(2, written.length / 2) + 1
  for (const name of known) {
    const wanted = name.toLowerCase()
    // Half of a long name is as good as a slip of the pen.
    const isPart = written.length > 2 && wanted.includes(written.toLowerCase())
    const edits = isPart ? 1 : editDistance(written.toLowerCase(), wanted)
    if (edits < fewest) {
      fewest = edits
      best = name
    }
  }
  return best
}

/** How many letters must be put in, left out or changed to turn one word into the other (Wagner and Fischer, 1974). */
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
