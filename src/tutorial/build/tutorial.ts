import { Book } from './book.ts'
import { contentsHtml } from './contents.ts'
import type { Env } from './env.ts'
import { nameOf } from './headings.ts'
import type { Highlight } from './highlight.ts'
import { markdown } from './markdown.ts'
import type { Materials } from './materials.ts'
import type { TextProblem } from './problem.ts'

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
