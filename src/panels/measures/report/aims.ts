import { html } from 'lit'
import type { Report } from '../../../report/schema.ts'
import { plain } from '../../../chart/numbers.ts'

/** What the project asks of itself, met or not, and where the time goes of what took too long. */
export function aims({ targets, profiles }: Report) {
  return html`<div class="scroll" tabindex="0" role="region" aria-label="Targets, table">
      <table>
        <caption>
          What this project asks of itself
        </caption>
        <thead>
          <tr>
            <th scope="col">Target</th>
            <th scope="col">Asked for</th>
            <th scope="col">Measured</th>
            <th scope="col">Result</th>
            <th scope="col" class="prose">Where</th>
          </tr>
        </thead>
        <tbody>
          ${targets.map(
            ({ label, sense, limit, figure, met, from }) =>
              html`<tr>
                <th scope="row">${label}</th>
                <td>${sense} ${plain(limit)}</td>
                <td>${plain(figure)}</td>
                <td>${met ? 'met' : 'missed'}</td>
                <td class="prose">${from}</td>
              </tr>`,
          )}
        </tbody>
      </table>
    </div>
    ${
      profiles.length > 0
        ? html`<p>Where the time goes of what missed the most:</p>
            <ul>
              ${profiles.map(
                ({ what, functions }) =>
                  html`<li>
                    ${what}:
                    ${functions.map(({ name, share }) => `${name} ${Math.round(100 * share)}\u2009%`).join(', ')}
                  </li>`,
              )}
            </ul>`
        : ''
    }`
}
