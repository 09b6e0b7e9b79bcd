import { html, nothing } from 'lit'
import type { LitElement } from 'lit'

/**
 * Lets what an element shows be unfolded as a table, which is made as soon as it is wanted.
 *
 * @returns its template; `what` is shown, in small letters
 */
export function tableFold(host: LitElement) {
  let open = false
  const toggled = (event: Event) => {
    open = (event.target as HTMLDetailsElement).open
    host.requestUpdate()
  }
  return (what: string, table: () => unknown) =>
    html`<details @toggle=${toggled}>
      <summary>As a table<span class="visually-hidden">: ${what}</span></summary>
      ${open ? table() : nothing}
    </details>`
}
