import createMarkdown from 'markdown-it'
import type { MarkdownIt } from 'markdown-it'
import { braces } from './braces.ts'
import { fences } from './fences.ts'
import { headings } from './headings.ts'
import { maths } from './maths.ts'
import { resolve } from './resolve.ts'
import { spans } from './spans.ts'

/** Markdown without HTML, and with what this tutorial needs besides. */
export function markdown(): MarkdownIt {
  const md = createMarkdown({ html: false })
  for (const rule of [maths, spans, braces, fences, headings, resolve]) md.use(rule)
  const table = md.renderer.rules.table_open
  md.renderer.rules.table_open = (...all) =>
    `<div class="table" data-label="Table">${table?.(...all) ?? '<table>\n'}`
  md.renderer.rules.table_close = () => '</table></div>\n'
  return md
}
