import { readdirSync, readFileSync } from 'node:fs'
import { join, resolve } from 'node:path'

const folder = resolve(import.meta.dirname, '../../src/tutorial/text')

/** The files of the tutorial's text in the order of the page: their names and their markdown. */
export const texts: readonly { readonly name: string; readonly markdown: string }[] = readdirSync(
  folder,
)
  .filter((name) => name.endsWith('.md'))
  .sort()
  .map((name) => ({ name, markdown: readFileSync(join(folder, name), 'utf8') }))

/** The prose of a markdown text: captions, headings and tables included; code, formulas, addresses and facts left out. */
export function prose(markdown: string): string {
  return (
    markdown
      // Of a figure's or a source's block only the caption is prose; of any other block nothing.
      .replace(/^```(?:figure|source)\b.*\n([\s\S]*?)^```$/gm, '$1')
      .replace(/^```[\s\S]*?^```$/gm, '')
      .replace(/\$\$[\s\S]*?\$\$/g, ' ')
      .replace(/\$[^$\n]+(?:\n[^$\n]+)?\$/g, ' ')
      .replace(/`[^`\n]+`/g, ' ')
      .replace(/\{\{[^}]*\}\}/g, ' ')
      .replace(/\]\([^)]*\)/g, ']')
      .replace(/\]\{[^}]*\}/g, ']')
      .replace(/[*_[\]|]/g, '')
  )
}
