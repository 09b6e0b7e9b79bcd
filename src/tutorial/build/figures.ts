import { placeOf } from './env.ts'
import type { Env } from './env.ts'
import { attributes } from './html.ts'

/** A figure with its still picture, which stays where there is no JavaScript, and its caption. */
export function figureHtml(env: Env, name: string, caption: string, line: number): string {
  const { book } = env
  const place = placeOf(env, line)
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
