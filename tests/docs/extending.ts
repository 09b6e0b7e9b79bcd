import { existsSync, readFileSync } from 'node:fs'
import { join } from 'node:path'

/* docs/extending.md as instructions: which files it adds, and how it changes others. */

export const root = join(import.meta.dirname, '../..')

/** The sources as they are after everything in a text was done: the content of each file, by its path. */
export function followed(markdown: string): Map<string, string> {
  const files = new Map<string, string>()
  for (const [, kind, block] of markdown.matchAll(/```(ts|diff)\n([^]*?)```/g)) {
    const [, path, body] = /^ ?\/\/ (\S+)\n([^]*)$/.exec(block!)!
    if (kind === 'diff') files.set(path!, patched(path!, files.get(path!) ?? source(path!), body!))
    else if (existsSync(join(root, path!))) throw new Error(`${path} is there already.`)
    else files.set(path!, body!)
  }
  return files
}

function source(path: string): string {
  return readFileSync(join(root, path), 'utf8')
}

/**
 * A text after a diff, each of whose parts must fit at exactly one place. A line of `…` parts it; within a line, `…` stands
 * for what is there.
 */
export function patched(path: string, text: string, diff: string): string {
  return diff.split(/^ …\n/m).reduce((before, part) => {
    const lines = part.trimEnd().split('\n')
    const without = (sign: string) =>
      lines
        .filter((line) => !line.startsWith(sign))
        .map((line) => `${line.slice(1)}\n`)
        .join('')
    const old = without('+').replace(/[.*+?^${}()|[\]\\]/g, '\\$&')
    const places = [...before.matchAll(new RegExp(old.replaceAll('…', '(.*)'), 'g'))]
    if (places.length !== 1) throw new Error(`${path} has ${places.length} times:\n${part}`)
    const [{ 0: found, 1: elided = '', index }] = places as [RegExpExecArray]
    const now = without('-').replace('…', () => elided)
    return before.slice(0, index) + now + before.slice(index + found.length)
  }, text)
}
