import { html } from 'lit'
import type { Report } from '../../../report/schema.ts'
import { plain } from '../../../chart/numbers.ts'
import { time } from './stepTimes.ts'

/** What a time step of an engine costs with one block on one ramp. */
export function engineTimes({ peers, contestants }: Report) {
  return html`<div class="scroll" tabindex="0" role="region" aria-label="Engines, time, table">
    <table>
      <caption>
        One block sliding down one ramp: time of a step. Engines also turn, collide and stack; this
        project does only what the scene needs
      </caption>
      <thead>
        <tr>
          <th scope="col">Engine</th>
          <th scope="col">Time of a step</th>
          <th scope="col">Times ours</th>
          <th scope="col" class="prose">How it is set up</th>
        </tr>
      </thead>
      <tbody>
        ${peers.times.map(({ engine, step, ratio }) => {
          const who = contestants.find(({ id }) => id === engine)
          return html`<tr>
            <th scope="row">${who?.label ?? engine}<small>${who?.version ?? ''}</small></th>
            ${time(step.median)}
            <td>${plain(ratio)}</td>
            <td class="prose">${withCode(who?.setup ?? '')}</td>
          </tr>`
        })}
      </tbody>
    </table>
  </div>`
}

/** A text in which names of the code stand between backticks. */
function withCode(text: string) {
  return text.split('`').map((part, i) => (i % 2 === 1 ? html`<code>${part}</code>` : part))
}
