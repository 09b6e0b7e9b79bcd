import { html } from 'lit'
import type { LabView } from './labView.ts'
import { aboutOf, modeOf, modes } from './state/modes.ts'

/** The buttons that set all runners at once, and what the one that is pressed does. */
export function modeButtons({ simulated, preset, change }: LabView) {
  const mode = modeOf(simulated.state)
  return html`<div class="modes" part="modes">
    <div class="segments" role="group" aria-label="All runners at once">
      ${modes.map(
        ({ id, label }) =>
          html`<button
            type="button"
            aria-pressed=${id === mode?.id}
            @click=${() => change({ kind: 'mode', mode: id })}
          >
            ${label}
          </button>`,
      )}
    </div>
    <p class="about">
      ${mode ? aboutOf(mode, simulated.state) : `A mixture${preset ? '' : ' of your own'}. Any of the buttons sets all runners to one way again.`}
    </p>
  </div>`
}
