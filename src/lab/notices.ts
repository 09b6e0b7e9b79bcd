import { html, nothing } from 'lit'
import { icon } from '../ui/icons.ts'
import type { LabView } from './labView.ts'

/** What was wrong with the link that led here, a line for each problem. */
export function linkProblems(message: string) {
  if (!message) return nothing
  return html`<div class="link-problems" role="alert">
    <p>This link asks for something that can’t be run. The lab shows its opening instead.</p>
    <ul>
      ${message.split('\n').map((line) => html`<li>${line}</li>`)}
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
