import { html } from 'lit'
import { scenes } from '../physics/index.ts'
import { viewOf } from '../view/scenes.ts'
import type { LabView } from './labView.ts'

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
