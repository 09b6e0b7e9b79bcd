import { html, nothing } from 'lit'
import { icon } from '../ui/icons.ts'
import type { LabView } from './labView.ts'

/** Why the lab does not show what was asked for: a sentence, then a line for each problem. */
export function refusalNotice(problem: string) {
  if (!problem) return nothing
  const [sentence, ...lines] = problem.split('\n')
  return html`<div class="refusal" role="alert">
    <p>${sentence}</p>
    <ul>
      ${lines.map((line) => html`<li>${line}</li>`)}
    </ul>
  </div>`
}

/** What to watch in the preset that was chosen, until it is closed. */
export function presetNote({ preset, dismiss }: LabView) {
  if (!preset) return nothing
  return html`<p><b>${preset.label}.</b> ${preset.watch}</p>
    <button type="button" title="Close" aria-label="Close the note" @click=${dismiss}>
      ${icon('remove')}
    </button>`
}
