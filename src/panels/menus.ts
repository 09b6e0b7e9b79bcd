import { html } from 'lit'
import type { Menus } from '../lab/labView.ts'
import { engineChoices } from '../lab/presets/engines.ts'
import { presets } from '../lab/presets/index.ts'

const groups = [...new Set(presets.map(({ group }) => group))]

/** Presets and engines, and the menus' options, which are made once: they are many, and never change. */
export const menus: Menus = {
  presets,
  presetOptions: groups.map(
    (name) =>
      html`<optgroup label=${name}>
        ${presets.map(({ group, label }, i) =>
          group === name ? html`<option value=${i}>${label}</option>` : '',
        )}
      </optgroup>`,
  ),
  engines: engineChoices,
  engineOptions: engineChoices.map(({ label }, i) => html`<option value=${i}>${label}</option>`),
}
