import { html } from 'lit'
import { lengthText, place } from '../chart/numbers.ts'
import type { LabView } from './labView.ts'
import type { Counting } from './openingRun.ts'
import { atNow } from './playback/atNow.ts'
import { sameMethod } from './state/modes.ts'
import { spreadText } from './state/spreadText.ts'

/**
 * The number that it is all about: how far apart the frame rates end. Between blocks that differ in more than their frames it
 * says nothing of frame rates, and has another name.
 */
export function spreadNumber({ simulated: { spread, visible } }: LabView, counting: Counting) {
  const [first, ...others] = visible
  const label = others.every((each) => sameMethod(each.state, first!.state))
    ? 'frame-rate spread'
    : 'apart at the end'
  // One block alone is apart from nothing.
  if (!spread || visible.length < 2)
    return html`<p class="spread" part="spread">
      <span>${label}</span>
      <output title="The spread needs two visible runners.">–</output>
    </p>`
  const textOf = (part: number) =>
    spreadText(spread, part < 1 ? (length) => place(part * length) : lengthText)
  const { value, remark, title } = textOf(counting.time)
  return html`<p class="spread" part="spread">
    <span>${label}</span>
    <output title=${title} aria-busy=${counting.time < 1} ?data-words=${!/\d/.test(value)}
      >${atNow(counting, (part) => textOf(part).value)}
      ${remark ? html`<small>(${remark})</small>` : ''}</output
    >
  </p>`
}
