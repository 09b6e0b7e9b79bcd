import { html } from 'lit'
import type { FrameTime, Report } from '../../../report/schema/index.ts'
import { integrators, scenes } from '../../../physics/index.ts'
import { plain, raw, seconds } from '../../../chart/numbers.ts'

/** What a call of `run.frame` costs, beside the loop that somebody would write by hand for just this. */
export function frameTimes({ frames }: Report) {
  return html`<div class="scroll" tabindex="0" role="region" aria-label="Time of a frame, table">
    <table>
      <caption>
        A call for each step: a loop written by hand for one scene and one method, and run.frame
      </caption>
      <thead>
        <tr>
          <th scope="col">Scene</th>
          <th scope="col">Method</th>
          <th scope="col">Handwritten loop</th>
          <th scope="col">run.frame, alone</th>
          <th scope="col">run.frame, after all others</th>
        </tr>
      </thead>
      <tbody>
        ${frames.map(row)}
      </tbody>
    </table>
  </div>`
}

function row({ scene, integrator, handwritten, alone, mixed, ratios }: FrameTime) {
  return html`<tr>
    <th scope="row">${labelOf(scenes, scene)}</th>
    <td>${labelOf(integrators, integrator)}</td>
    ${time(handwritten.median)} ${time(alone.median, ratios.alone)}
    ${mixed ? time(mixed.median, ratios.mixed) : html`<td>–</td>`}
  </tr>`
}

/** Of so many ns, and how many times the handwritten loop's of the same round. */
export function time(nanoseconds: number, ratio?: number | null) {
  return html`<td title="${raw(nanoseconds)} ns">
    ${seconds(nanoseconds * 1e-9)}${ratio ? html`<small>${plain(ratio)} ×</small>` : ''}
  </td>`
}

function labelOf(list: readonly { id: string; label: string }[], id: string): string {
  return list.find((each) => each.id === id)?.label ?? id
}
