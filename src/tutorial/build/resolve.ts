import type { MarkdownIt, Token } from 'markdown-it'
import { escaped, attributes } from '../still/html.ts'
import { textPlaceOf } from './book.ts'
import type { Env, Book } from './book.ts'
import type { Brace } from './braces.ts'
import { resolveLink } from './links.ts'
import { mathml } from './maths.ts'
import { instead } from './problem.ts'
import type { TextPlace } from './problem.ts'
import { words } from './spans.ts'
import { wrongValue } from './presets.ts'

/** Gives everything that the text names its meaning: facts, figures, links, terms, maths. Here its line is known. */
export function resolve(md: MarkdownIt): void {
  md.core.ruler.push('resolve', ({ tokens, env: given }) => {
    const env = given as Env
    const { book } = env
    for (const token of tokens) {
      let line = token.map?.[0] ?? 0
      if (token.type === 'equation') resolveMaths(token, true, env, line)
      for (const child of token.children ?? []) {
        const place = textPlaceOf(env, line)
        if (child.type === 'softbreak' || child.type === 'hardbreak') line++
        else if (child.type === 'maths') resolveMaths(child, false, env, line)
        else if (child.type === 'brace') child.content = braceHtml(child.meta as Brace, env, place)
        else if (child.type === 'span_open') resolveSpan(child, env, place)
        else if (child.type === 'link_open') {
          const { href, attributes } = resolveLink(
            decoded(String(child.attrGet('href') ?? '')),
            book,
            place,
          )
          child.attrSet('href', href)
          for (const [name, value] of attributes) child.attrSet(name, value)
        }
      }
    }
  })
  md.core.ruler.push('together', ({ tokens }) => {
    for (const { children } of tokens) keepTogether(children ?? [])
  })
  for (const type of ['maths', 'equation', 'brace'])
    md.renderer.rules[type] = (tokens, index) => tokens[index]!.content
}

/** A formula and the comma after it: browsers would break the line between them. */
function keepTogether(children: readonly Token[]): void {
  children.forEach((child, i) => {
    const next = children[i + 1]
    const sign = next?.type === 'text' && /^[,.;:!?)’”]+/.exec(next.content)?.[0]
    if (child.type !== 'maths' || !next || !sign) return
    child.content = `<span class="together">${child.content}${sign}</span>`
    next.content = next.content.slice(sign.length)
  })
}

/** markdown-it encodes what it takes for an address of the web. */
function decoded(href: string): string {
  return decodeURIComponent(href)
}

function resolveMaths(token: Token, display: boolean, env: Env, line: number): void {
  try {
    const html = mathml(token.content, display)
    token.content = display ? `<div class="equation" data-label="Equation">${html}</div>\n` : html
  } catch (error) {
    const reason = error instanceof Error ? error.message.replace(/\s+/g, ' ') : String(error)
    env.book.report(textPlaceOf(env, line), `$${token.content}$ is no TeX: ${reason}`)
    token.content = ''
  }
}

function braceHtml(brace: Brace, { book }: Env, place: TextPlace): string {
  if (brace.kind === 'dial') return dialHtml(brace, book, place)
  const { facts } = book.materials
  const fact = Object.hasOwn(facts, brace.name) ? facts[brace.name] : undefined
  if (fact) return escaped(fact())
  book.report(place, `there is no fact “${brace.name}”${instead(brace.name, Object.keys(facts))}`)
  return ''
}

function resolveSpan(token: Token, { book }: Env, place: TextPlace): void {
  const { name } = token.meta as { name: string }
  if (token.tag === 'dfn') {
    book.give(name, place)
    token.attrSet('id', name)
  } else {
    if (!words.includes(name))
      book.report(place, `there is no class “${name}”${instead(name, words)}`)
    token.attrSet('class', `word ${name}`)
  }
}

type Dial = Extract<Brace, { kind: 'dial' }>

/**
 * A number that the page's script turns into a field to drag and to type in. Without it, it is a number. It must be the
 * one that the figure opens with.
 */
function dialHtml(dial: Dial, book: Book, place: TextPlace): string {
  const { figure: id, control: name, value, unit } = dial
  const figure = book.figure(id, place)
  const control = figure?.controls[name]
  book.link(`figure-${id}`, place)
  const wrong = figure && wrongValue(figure, name, value)
  if (wrong) book.report(place, wrong)
  else if (control && control.type !== 'number')
    book.report(place, `${name} of the figure “${id}” is no number: a set: link can set it`)
  else if (control && Number(value) !== control.initial)
    book.report(place, `the figure “${id}” opens with ${name} = ${control.initial}, not ${value}`)
  const slider =
    figure && control?.type === 'number'
      ? {
          'data-label': `${control.label} in the figure “${figure.title}”`,
          'data-min': control.from,
          'data-max': control.to,
          'data-step': control.step,
        }
      : {}
  const data = attributes({ 'data-figure': id, 'data-control': name, ...slider })
  const number = `<span class="dial"${data}>${escaped(value.replace('-', '−'))}</span>`
  // A number and its unit stay on one line; degrees stand close to it.
  const gap = unit === '°' || unit === '' ? '' : '\u00a0'
  return `${number}${gap}${escaped(unit)}`
}
