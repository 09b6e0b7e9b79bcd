import { html } from 'lit'
import { scenes } from '../physics/index.ts'
import { viewOf } from '../view/scenes.ts'
import { segments } from '../ui/segments.ts'
import type { LabView } from './labView.ts'
import { aboutOf, modeOf, modes } from './state/modes.ts'

/** The choice of scene. */
export function sceneTabs({ simulated, change }: LabView, name: string) {
  return html`<fieldset class="scenes">
    <legend class="visually-hidden">Scene</legend>
    ${scenes.map(
      ({ id, label, about }) =>
        html`<label title=${about}>
          <input
            type="radio"
            class="visually-hidden"
            name=${name}
            value=${id}
            .checked=${id === simulated.state.scene}
            @change=${() => change({ kind: 'scene', scene: id })}
          />
          <svg viewBox="0 0 32 20" aria-hidden="true"><path d=${viewOf({ id }).icon} /></svg>
          <span>${label}</span>
        </label>`,
    )}
  </fieldset>`
}

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
