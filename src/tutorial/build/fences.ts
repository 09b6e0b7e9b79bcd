import type { MarkdownIt } from 'markdown-it'
import { attributes } from '../still/html.ts'
import { textPlaceOf } from './book.ts'
import type { Env } from './book.ts'
import { codeHtml, sourceHtml, takeHomeHtml } from './code.ts'
import { hardCasesHtml } from './hardCases.ts'

/**
 * Fenced blocks: a figure, lines of the project's own source, the take-home files, the hard cases, or code in a
 * language.
 */
export function fences(md: MarkdownIt): void {
  md.renderer.rules.fence = (tokens, index, _options, given) => {
    const env = given as Env
    const { info, content, map } = tokens[index]!
    const line = map?.[0] ?? 0
    const [kind = '', argument = ''] = info.trim().split(/\s+/)
    if (kind === 'take-home') return takeHomeHtml(env, line)
    if (kind === 'hard-cases') return hardCasesHtml(env, line)
    if (kind !== 'figure' && kind !== 'source') return codeHtml(env, content, kind, line)
    const caption = md.render(content, { ...env, firstLine: env.firstLine + line + 1 }).trim()
    return kind === 'figure'
      ? figureHtml(env, argument, caption, line)
      : sourceHtml(env, argument, caption, line)
  }
}

/** A figure with its still picture, which stays where there is no JavaScript, and its caption. */
function figureHtml(env: Env, name: string, caption: string, line: number): string {
  const { book } = env
  const place = textPlaceOf(env, line)
  const figure = book.figure(name, place)
  const id = `figure-${name}`
  book.give(id, place)
  const label = `<a href="#${id}">Figure ${book.nextFigure()}</a>`
  if (!caption) book.report(place, `the figure “${name}” has no caption`)
  const words = caption.replace(/^<p>/, `<p><span class="figure-number">${label}.</span> `)
  const attrs = attributes({ name, style: figure?.frame })
  const element = `<slide-figure${attrs}>${figure?.still ?? ''}</slide-figure>`
  return `<figure class="figure" id="${id}">${element}
<figcaption>${words}</figcaption></figure>\n`
}
