import { html } from 'lit'
import { guard } from 'lit/directives/guard.js'
import { live } from 'lit/directives/live.js'
import type { LabView } from '../labView.ts'
import { presets } from './index.ts'

const groups = [...new Set(presets.map(({ group }) => group))]

/** The menu of presets. It names the one that is shown for as long as nothing of it is changed. */
export function presetMenu({ simulated, preset, load }: LabView) {
  const isShown = preset?.shown.state === simulated.state
  return html`<select
    class="presets"
    aria-label="Preset"
    .value=${live(isShown ? String(presets.indexOf(preset)) : '-1')}
    @change=${(event: Event) => load(presets[Number((event.target as HTMLSelectElement).value)]!)}
  >
    <option value="-1" disabled selected>Presets</option>
    ${guard([], () =>
      groups.map(
        (name) =>
          html`<optgroup label=${name}>
            ${presets.map(({ group, label }, i) =>
              group === name ? html`<option value=${i}>${label}</option>` : '',
            )}
          </optgroup>`,
      ),
    )}
  </select>`
}
