import { html } from 'lit'
import { icon } from '../ui/icons.ts'
import type { LabView } from './labView.ts'

/** What to watch in the preset that was chosen, until it is closed. */
export function presetNote({ preset, dismiss }: LabView) {
  // The region that speaks is there before there is something to say.
  return html`<div class="preset-note" role="status">
    ${
      preset &&
      html`<p><b>${preset.label}.</b> ${preset.watch}</p>
        <button type="button" title="Close" aria-label="Close the note" @click=${dismiss}>
          ${icon('remove')}
        </button>`
    }
  </div>`
}
