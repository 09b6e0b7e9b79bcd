import { html } from 'lit'
import { numeral } from '../../chart/magnitudes.ts'
import { raw } from '../../chart/numbers.ts'

/** Words with numbers between them. The numbers stay numbers, so that they can be rounded for reading and shown raw. */
export type Said = readonly (string | number)[]

/** A sentence as a template: numbers in it are kept as such, what was said already is taken in. */
export function say(words: TemplateStringsArray, ...values: (string | number | Said)[]): Said {
  return words.flatMap((word, i) => [word, ...([values[i] ?? []].flat() as Said)])
}

/** The same as plain text, with each number as `numeral` writes it. */
export function textOf(said: Said): string {
  return said.map((each) => (typeof each === 'number' ? numeral(each) : each)).join('')
}

/** “1 step”, “6 steps”. */
export function counted(number: number, what: string, several = `${what}s`): string {
  return `${number} ${number === 1 ? what : several}`
}

/** What was said, on the page: each number rounded, with all of its digits where it is pointed at. */
export function saidHtml(said: Said) {
  return said.map((each) =>
    typeof each === 'number'
      ? html`<span title=${raw(each)}>${numeral(each)}</span>`
      : each.split(/(?<=μ)([sk])/).map((part, i) => (i % 2 ? html`<sub>${part}</sub>` : part)),
  )
}
