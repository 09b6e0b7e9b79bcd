import { html } from 'lit'
import type { Menus } from '../lab/labView.ts'
import { engineChoices } from '../lab/presets/engines.ts'
import { presets } from '../lab/presets/index.ts'

function option(value: number, label: string, chosen: number) {
  return html`<option value=${value} .selected=${value === chosen}>${label}</option>`
}

const groups = [...new Set(presets.map(({ group }) => group))]

/** Presets and engines, and the menus' options. */
export const menus: Menus = {
  presets,
  presetOptions: (chosen) =>
    groups.map(
      (name) =>
        html`<optgroup label=${name}>
          ${presets.map(({ group, label }, i) => (group === name ? option(i, label, chosen) : ''))}
        </optgroup>`,
    ),
  engines: engineChoices,
  engineOptions: (chosen) => engineChoices.map(({ label }, i) => option(i, label, chosen)),
}
