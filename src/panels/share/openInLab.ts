import { html } from 'lit'
import type { LabState } from '../../lab/state/state.ts'
import { site } from '../../lab/site.ts'
import { linkTo } from './texts.ts'

/** The way from a figure in somebody's page to the whole lab. */
export function openInLab(state: LabState) {
  return html`<p class="open-in-lab" part="link">
    <a href=${linkTo('index.html', site(), state)} target="_blank" rel="noopener"
      >Open in the lab</a
    >
  </p>`
}
