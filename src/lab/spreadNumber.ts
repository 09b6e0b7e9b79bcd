import { html } from 'lit'
import { raw, lengthText } from '../chart/numbers.ts'
import { sameMethod } from './state/modes.ts'
import type { LabView } from './labView.ts'

/**
 * The number that it is all about: how far apart the frame rates end. Between blocks that differ in more than their frames it
 * says nothing of frame rates, and has another name.
 */
export function spreadNumber({ simulated: { spread, visible } }: LabView) {
  const [first, ...others] = visible
  const label = others.every((each) => sameMethod(each.state, first!.state))
    ? 'frame-rate spread'
    : 'apart at the end'
  // One block alone is apart from nothing.
  if (visible.length < 2)
    return html`<p class="spread" part="spread">
      <span>${label}</span>
      <output title="It takes two visible runners to be apart.">–</output>
    </p>`
  const [number, remark] = lengthText(spread).split(/ (?=\()/)
  return html`<p class="spread" part="spread">
    <span>${label}</span>
    <output title="Largest − smallest final position: ${raw(spread)} m"
      >${number} ${remark ? html`<small>${remark}</small>` : ''}</output
    >
  </p>`
}
