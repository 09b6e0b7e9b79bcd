/** Where something stands in the text. */
export interface TextPlace {
  /** The file, as from the project's root. */
  readonly file: string
  /** Counted from 1. */
  readonly line: number
}

/** Something in the text that has to be mended before it can be a page. */
export interface TextProblem extends TextPlace {
  readonly message: string
}

/** All that is wrong with the tutorial's text, a line for each: file, line, what, and what there is instead. */
export class TextError extends Error {
  readonly problems: readonly TextProblem[]

  constructor(problems: readonly TextProblem[]) {
    const lines = problems.map(({ file, line, message }) => `  ${file}:${line}  ${message}`)
    super(['The tutorial can’t be built:', ...lines].join('\n'))
    this.name = 'TextError'
    this.problems = problems
    // Where in this code it was noticed is of no use to who wrote the text.
    this.stack = this.message
  }
}

/**
 * “, did you mean …?” with the name that is nearest to a wrong one, or what names there are; empty where there are
 * none.
 */
export function instead(wrong: string, names: Iterable<string>): string {
  const all = [...names]
  const ranked = all
    .map((name) => ({ name, distance: editDistance(wrong, name) }))
    .sort((a, b) => a.distance - b.distance)
  const nearest = ranked[0]
  if (!nearest) return ''
  if (nearest.distance <= Math.max(2, wrong.length / 3)) return `: did you mean “${nearest.name}”?`
  return all.length <= 12 ? `: there is ${all.join(', ')}` : ''
}

/** How many letters have to be put in, taken out or changed (Levenshtein). */
function editDistance(a: string, b: string): number {
  let row = Array.from({ length: b.length + 1 }, (_, i) => i)
  for (let i = 1; i <= a.length; i++) {
    const next = [i]
    for (let j = 1; j <= b.length; j++)
      next.push(
        Math.min(row[j]! + 1, next[j - 1]! + 1, row[j - 1]! + (a[i - 1] === b[j - 1] ? 0 : 1)),
      )
    row = next
  }
  return row[b.length]!
}
