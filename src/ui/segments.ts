import { html, nothing } from 'lit'

interface Segment {
  readonly id: string
  readonly label: string
  /** The tooltip. */
  readonly about?: string
}

interface Segments<Each extends Segment> {
  /** The group's name for screen readers. */
  readonly label: string
  readonly list: readonly Each[]
  readonly chosen: string | undefined
  readonly pick: (each: Each) => void
}

/** Buttons side by side, of which one is pressed. */
export function segments<Each extends Segment>({ label, list, chosen, pick }: Segments<Each>) {
  return html`<div class="segments" role="group" aria-label=${label}>
    ${list.map(
      (each) =>
        html`<button
          type="button"
          aria-pressed=${each.id === chosen}
          title=${each.about ?? nothing}
          @click=${() => pick(each)}
        >
          ${each.label}
        </button>`,
    )}
  </div>`
}
