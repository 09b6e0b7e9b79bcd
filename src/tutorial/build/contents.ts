import type { Chapter } from './book.ts'
import { escaped } from './html.ts'

/** The table of contents. The page’s script closes it on narrow screens. */
export function contentsHtml(chapters: readonly Chapter[]): string {
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
