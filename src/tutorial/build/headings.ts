import type { MarkdownIt, Token } from 'markdown-it'
import { textPlaceOf } from './book.ts'
import type { Chapter, Env } from './book.ts'

/** `01-what-moves.md` is section 1 with the id `what-moves`; `references.md` has no number. */
export function nameOf(path: string): { id: string; number: number | undefined } {
  const [, digits, id] = /(?:(\d+)-)?([^/]+)\.md$/.exec(path)!
  return { id: id!, number: digits === undefined ? undefined : Number(digits) }
}

/**
 * `# Title` once a file, `##` and `###` below it; each is a link to itself. Below the page's own title they are a level
 * lower. An id other than the title's own is written at the end: `## Title {#id}`.
 */
export function headings(md: MarkdownIt): void {
  md.core.ruler.after('inline', 'headings', ({ tokens, env: given }) => {
    const env = given as Env
    const { book, file } = env
    const name = nameOf(file)
    let titles = 0
    tokens.forEach((open, i) => {
      if (open.type !== 'heading_open') return
      const place = textPlaceOf(env, open.map![0]!)
      const level = Number(open.tag.slice(1))
      const inline = tokens[i + 1]!
      const own = takeId(inline)
      const title = plain(inline)
      if (level === 1) {
        if (titles++ > 0) book.report(place, 'a second # in one file: ## is the next level')
        else book.chapters.push({ id: name.id, title, number: name.number } satisfies Chapter)
      }
      const id = own ?? (level === 1 ? name.id : slug(title))
      if (level > 1) open.attrSet('id', id)
      book.give(id, place)
      open.tag = tokens[i + 2]!.tag = `h${level + 1}`
      open.meta = { id, number: level === 1 ? name.number : undefined }
    })
  })
  const { renderer } = md
  renderer.rules.heading_open = (tokens, index, options, _env, self) => {
    const { id, number } = tokens[index]!.meta as { id: string; number: number | undefined }
    const numeral = number === undefined ? '' : `<span class="numeral">${number}</span> `
    return `${self.renderToken(tokens, index, options)}<a href="#${id}">${numeral}`
  }
  renderer.rules.heading_close = (tokens, index, options, _env, self) =>
    `</a>${self.renderToken(tokens, index, options)}`
}

/** Takes `{#id}` off the end of a heading. */
function takeId({ children }: Token): string | undefined {
  const last = children?.at(-1)
  const match = last && /\s*\{#([\w-]+)\}$/.exec(last.content)
  if (!match) return undefined
  last.content = last.content.slice(0, match.index)
  return match[1]
}

/** The words of a heading without their marks. */
function plain({ children }: Token): string {
  return (children ?? []).map(({ content }) => content).join('')
}

/** “What moves?” → `what-moves`. */
function slug(title: string): string {
  return title
    .toLowerCase()
    .replace(/[’']/g, '')
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '')
}
