import { attributes, escaped } from '../still/html.ts'
import type { Book } from './book.ts'
import type { Brace } from './braces.ts'
import { wrongValue } from './presets.ts'
import type { TextPlace } from './problem.ts'

type Dial = Extract<Brace, { kind: 'dial' }>

/**
 * A number that the page's script turns into a field to drag and to type in. Without it, it is a number. It must be the
 * one that the figure opens with.
 */
export function dialHtml(dial: Dial, book: Book, place: TextPlace): string {
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
