import { html, nothing } from 'lit'
import type { Measuring } from './measuring.ts'

/** How far measuring has come, with a button that stops it, or what went wrong. It has its room at all times. */
export function progress(measuring: Measuring) {
  const { busy, done, problem, notice, stopped } = measuring
  return html`<div class="progress">
    ${
      busy
        ? html`<progress max="1" .value=${done} aria-label="Measuring"></progress>
            <button type="button" @click=${() => measuring.cancel()}>Cancel</button>`
        : nothing
    }
    ${
      stopped || problem
        ? html`<button type="button" @click=${() => measuring.again()}>Measure</button>`
        : nothing
    }
    <p role="status">${[problem, notice, stopped ? 'Cancelled.' : ''].filter(Boolean).join(' ')}</p>
  </div>`
}
