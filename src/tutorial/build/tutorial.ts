import createMarkdown from 'markdown-it'
import type { MarkdownIt } from 'markdown-it'
import { escaped } from '../still/html.ts'
import { Book } from './book.ts'
import type { Chapter, Env } from './book.ts'
import { nameOf, headings } from './headings.ts'
import type { Highlight } from './highlight.ts'
import type { Materials } from './materials.ts'
import type { TextProblem } from './problem.ts'
import { braces } from './braces.ts'
import { fences } from './fences.ts'
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

/** The tutorial as HTML, its contents and its sections; and everything in the text that has to be mended. */
export function tutorialHtml(
  materials: Materials,
  highlight: Highlight,
): { html: string; problems: readonly TextProblem[] } {
  const book = new Book(materials)
  const md = markdown()
  const sections = materials.texts.map(({ path, text }) => {
    const env: Env = { book, highlight, file: path, firstLine: 0 }
    const { id } = nameOf(path)
    const html = md.render(text, env)
    if (!book.chapters.some((chapter) => chapter.id === id))
      book.report({ file: path, line: 1 }, 'the file has no # title')
    return `<section id="${id}">\n${html}</section>`
  })
  book.checkLinks()
  const html = `<div class="tutorial" id="tutorial">
${contentsHtml(book.chapters)}
<article class="text">
${sections.join('\n')}
</article>
</div>`
  return { html, problems: book.problems }
}

/** The table of contents. The page’s script closes it on narrow screens. */
function contentsHtml(chapters: readonly Chapter[]): string {
  const items = chapters.map(({ id, title, number }) => {
    const numeral = `<span class="numeral">${number ?? ''}</span>`
    return `<li><a href="#${id}">${numeral}<span>${escaped(title)}</span></a></li>`
  })
  return `<nav class="contents" aria-label="Contents">
<details open><summary>Contents</summary>
<ul role="list">
${items.join('\n')}
</ul></details>
</nav>`
}
