import { html, svg } from 'lit'
import { scenes } from '../physics/index.ts'
import type { SceneId } from '../physics/index.ts'
import type { LabView } from './labView.ts'

/** A line drawing of each scene, 32 by 20. */
const drawings: Readonly<Record<SceneId, ReturnType<typeof svg>>> = {
  fall: svg`<circle cx="16" cy="13" r="4" /><path d="M16 6V1M11 5V2M21 5V2M6 19H26" />`,
  ramp: svg`<path d="M2 18H30L2 4ZM11.5 6.6l6 3 2.2-4.4-6-3Z" />`,
  'run-out': svg`<path d="M2 3L11 13Q15 18 21 18H30M8 6.3l3.6 4 3.4-3-3.6-4Z" />`,
  'half-pipe': svg`<path d="M4 3A12.5 12.5 0 0 0 28 3" /><rect x="6.2" y="5.3" width="5" height="5" transform="rotate(52 8.7 7.8)" />`,
  spring: svg`<path d="M2 3V17M2 10H5L7 6L10 14L13 6L16 14L18 10H20" /><rect x="20" y="6" width="8" height="8" />`,
}

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
          <svg viewBox="0 0 32 20" aria-hidden="true">${drawings[id]}</svg>
          <span>${label}</span>
        </label>`,
    )}
  </fieldset>`
}
