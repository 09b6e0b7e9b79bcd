import { html } from 'lit'
import type { Described } from '../physics/index.ts'

interface Menu {
  /** For whoever can't see where it stands. */
  readonly label: string
  readonly list: readonly Described[]
  readonly chosen: string
  /** Whether it could be chosen. */
  readonly pick: (id: string) => boolean
}

/** A menu of a list's entries; what the chosen one is appears when it is pointed at. */
export function menu({ label, list, chosen, pick }: Menu) {
  const changed = (event: Event) => {
    const select = event.target as HTMLSelectElement
    if (!pick(select.value)) select.value = chosen
  }
  return html`<select
    aria-label=${label}
    title=${list.find(({ id }) => id === chosen)!.about}
    @change=${changed}
  >
    ${list.map(
      ({ id, label }) => html`<option value=${id} .selected=${id === chosen}>${label}</option>`,
    )}
  </select>`
}
