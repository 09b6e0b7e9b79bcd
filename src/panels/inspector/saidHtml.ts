import { html } from 'lit'
import { raw } from '../../chart/numbers.ts'
import { numeral } from './said.ts'
import type { Said } from './said.ts'

/** What was said, on the page: each number rounded, with all of its digits where it is pointed at. */
export function saidHtml(said: Said) {
  return said.map((each) =>
    typeof each === 'number'
      ? html`<span title=${raw(each)}>${numeral(each)}</span>`
      : each.split(/(?<=μ)([sk])/).map((part, i) => (i % 2 ? html`<sub>${part}</sub>` : part)),
  )
}
