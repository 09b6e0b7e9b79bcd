import { html, nothing, svg } from 'lit'

const shapes = {
  play: svg`<path d="M7 4.5v15l12-7.5Z" />`,
  pause: svg`<path d="M7 5h3.5v14H7ZM13.5 5H17v14h-3.5Z" />`,
  start: svg`<path d="M5 5h2.5v14H5ZM19 5v14L8.5 12Z" />`,
  back: svg`<path d="M15 6v12L6 12ZM16.5 6H18v12h-1.5Z" />`,
  on: svg`<path d="M9 6v12l9-6ZM6 6h1.5v12H6Z" />`,
  end: svg`<path d="M16.5 5H19v14h-2.5ZM5 5v14l10.5-7Z" />`,
  duplicate: svg`<path class="line" d="M8.5 8.5h10v10h-10ZM15.5 8.5v-3h-10v10h3" />`,
  remove: svg`<path class="line" d="M7 7l10 10M17 7L7 17" />`,
  reset: svg`<path class="line" d="M6.5 9.5H13a4 4 0 0 1 0 8H9M9.5 6.5l-3 3 3 3" />`,
  undo: svg`<path class="line" d="M9 5.5L5 9.5l4 4M5 9.5h8.5a4.75 4.75 0 0 1 0 9.5H10" />`,
  redo: svg`<path class="line" d="M15 5.5l4 4-4 4M19 9.5h-8.5a4.75 4.75 0 0 0 0 9.5H14" />`,
  eye: svg`<path class="line" d="M3.5 12c4-6.6 13-6.6 17 0c-4 6.6-13 6.6-17 0Z" /><circle cx="12" cy="12" r="2.6" />`,
  closedEye: svg`<path class="line" d="M3.5 12c4-6.6 13-6.6 17 0c-4 6.6-13 6.6-17 0ZM5 19L19 5" />`,
  theme: svg`<circle class="line" cx="12" cy="12" r="7" /><path d="M12 5a7 7 0 0 1 0 14Z" />`,
}

/** The drawing on a button, in the colour of its text. */
export function icon(name: keyof typeof shapes) {
  return html`<svg class="icon" viewBox="0 0 24 24" aria-hidden="true">${shapes[name]}</svg>`
}

export type IconName = keyof typeof shapes

interface IconButton {
  /** What it does, and in brackets the key that does it too. */
  readonly label: string
  readonly act: (event: Event) => void
  readonly className?: string
  readonly isDisabled?: boolean
}

/** A button with nothing but a drawing on it. */
export function iconButton(
  name: IconName,
  { label, act, className, isDisabled = false }: IconButton,
) {
  return html`<button
    type="button"
    class=${className ?? nothing}
    title=${label}
    aria-label=${label.replace(/ \(.*/, '')}
    ?disabled=${isDisabled}
    @click=${act}
  >
    ${icon(name)}
  </button>`
}
