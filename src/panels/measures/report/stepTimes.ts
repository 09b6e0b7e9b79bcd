import { html } from 'lit'
import type { Report, StepTime } from '../../../report/schema.ts'
import { integrators, scenes } from '../../../physics/index.ts'
import { plain, raw, seconds } from '../../../chart/numbers.ts'

/** What a step costs, beside the loop that somebody would write by hand for just this. */
export function stepTimes({ steps }: Report) {
  return html`<div class="scroll" tabindex="0" role="region" aria-label="Time of a step, table">
    <table>
      <caption>
        Time of a step: a loop written by hand for one scene and one method, and ours
      </caption>
      <thead>
        <tr>
          <th scope="col">Scene</th>
          <th scope="col">Method</th>
          <th scope="col">Motion</th>
          <th scope="col">Bare loop</th>
          <th scope="col">Ours, alone</th>
          <th scope="col">Ours, after all others</th>
          <th scope="col">Recorded by simulate</th>
        </tr>
      </thead>
      <tbody>
        ${steps.map(row)}
      </tbody>
    </table>
  </div>`
}

function row({ scene, integrator, trial, bare, alone, mixed, recorded, ratios }: StepTime) {
  return html`<tr>
    <th scope="row">${labelOf(scenes, scene)}</th>
    <td>${labelOf(integrators, integrator)}</td>
    <td>${trial}</td>
    ${time(bare.median)} ${time(alone.median, ratios.alone)}
    ${mixed ? time(mixed.median, ratios.mixed) : html`<td>–</td>`}
    ${time(recorded.median, ratios.recorded)}
  </tr>`
}

/** Of so many ns, and how many times the hand-written loop's of the same round. */
export function time(nanoseconds: number, ratio?: number | null) {
  return html`<td title="${raw(nanoseconds)} ns">
    ${seconds(nanoseconds * 1e-9)}${ratio ? html`<small>${plain(ratio)} ×</small>` : ''}
  </td>`
}

function labelOf(list: readonly { id: string; label: string }[], id: string): string {
  return list.find((each) => each.id === id)?.label ?? id
}
