/** What may come before `#region name` and `#endregion`: the comment signs of the languages. */
const sign = String.raw`^\s*(?:\/\/|#|--)?\s*`
const begins = new RegExp(`${sign}#region\\s+([\\w-]+)\\s*$`)
const ends = new RegExp(`${sign}#endregion\\b`)

/** The names of the regions that a source has. */
export function regionsOf(source: string): string[] {
  return source.split('\n').flatMap((line) => begins.exec(line)?.[1] ?? [])
}

/**
 * The lines of a source between `#region name` and its `#endregion`, moved to the left edge; without a name all of it.
 * The lines that mark regions are left out. Undefined where there is no such region, or where it has no end.
 */
export function regionOf(source: string, name?: string): string | undefined {
  const lines: string[] = []
  /** How many regions are open within the wanted one, itself included. */
  let depth = name === undefined ? 1 : 0
  let found = depth > 0
  for (const line of source.split('\n')) {
    const begun = begins.exec(line)?.[1]
    if (begun !== undefined) {
      if (depth > 0) depth++
      else if (begun === name && !found) {
        found = true
        depth = 1
      }
    } else if (ends.test(line)) {
      if (depth > 0 && (name !== undefined || depth > 1)) depth--
    } else if (depth > 0) lines.push(line)
  }
  const isWhole = name === undefined || depth === 0
  return found && isWhole ? dedented(lines).trim() : undefined
}

/** Without the spaces that all lines begin with, and without empty lines around. */
function dedented(lines: readonly string[]): string {
  const indents = lines.filter((line) => line.trim()).map((line) => line.search(/\S/))
  const indent = Math.min(...indents)
  // A final newline after the trim in `regionOf` would be a line more on the page.
  return lines
    .map((line) => line.slice(indent))
    .join('\n')
    .replace(/^\n+/, '')
}
