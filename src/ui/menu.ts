import { html } from 'lit'
import type { Described } from '../physics/index.ts'

interface Menu<Id extends string> {
  /** The menu's name for screen readers. */
  readonly label: string
  readonly list: readonly (Described & { readonly id: Id })[]
  readonly chosen: string
  /** Called with the chosen id; returns false if it can't be chosen. */
  readonly pick: (id: Id) => boolean
}

/** A menu of a list's entries; the chosen one's explanation is the tooltip. */
export function menu<Id extends string>({ label, list, chosen, pick }: Menu<Id>) {
  const changed = (event: Event) => {
    const select = event.target as HTMLSelectElement
    if (!pick(select.value as Id)) select.value = chosen
  }
  const shown = list.find(({ id }) => id === chosen)!
  return html`<select
    aria-label=${label}
    title=${shown.about}
    .style="--letters: ${shown.label.length}"
    @change=${changed}
  >
    ${list.map(
      ({ id, label }) => html`<option value=${id} .selected=${id === chosen}>${label}</option>`,
    )}
  </select>`
}
