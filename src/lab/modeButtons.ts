import { html } from 'lit'
import { segments } from '../ui/segments.ts'
import type { LabView } from './labView.ts'
import { aboutOf, modeOf, modes } from './state/modes.ts'

/** The buttons that set all runners at once, and what the one that is pressed does. */
export function modeButtons({ simulated, preset, change }: LabView) {
  const mode = modeOf(simulated.state)
  return html`<div class="modes" part="modes">
    ${segments({
      label: 'All runners at once',
      list: modes.map(({ id, label }) => ({ id, label })),
      chosen: mode?.id,
      pick: ({ id }) => change({ kind: 'mode', mode: id }),
    })}
    <p class="about">
      ${mode ? aboutOf(mode, simulated.state) : `A mixture${preset ? '' : ' of your own'}. Any of the buttons sets all runners to one way again.`}
    </p>
  </div>`
}
