import { html } from 'lit'
import { live } from 'lit/directives/live.js'
import type { LabView } from './labView.ts'
import type { Preset } from './presets/preset.ts'

/** The menu of presets. It names the one that is shown for as long as nothing of it is changed. */
export function presetMenu({ simulated, preset, load, presets }: LabView) {
  const isShown = preset?.shown.state === simulated.state
  return html`<select
    class="presets"
    aria-label="Preset"
    ?data-empty=${presets.length === 0}
    .value=${live(isShown ? String(presets.indexOf(preset)) : '-1')}
    @change=${(event: Event) => load(presets[Number((event.target as HTMLSelectElement).value)]!)}
  >
    <option value="-1" disabled selected>Presets</option>
    ${optionsOf(presets)}
  </select>`
}

const options = new WeakMap<readonly Preset[], unknown>()

/** Made once: they are many, and never change. */
function optionsOf(presets: readonly Preset[]): unknown {
  const known = options.get(presets)
  if (known) return known
  const groups = [...new Set(presets.map(({ group }) => group))]
  const made = groups.map(
    (name) =>
      html`<optgroup label=${name}>
        ${presets.map(({ group, label }, i) =>
          group === name ? html`<option value=${i}>${label}</option>` : '',
        )}
      </optgroup>`,
  )
  options.set(presets, made)
  return made
}
