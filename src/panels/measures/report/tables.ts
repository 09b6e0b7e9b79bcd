import { html } from 'lit'
import { integrators, scenes } from '../../../physics/index.ts'
import { withoutRounding } from '../../../measure/index.ts'
import { plain, raw, roughMetres, seconds } from '../../../chart/numbers.ts'
import { menu } from '../../../ui/menu.ts'
import type { EngineRun, Report, FrameTime } from '../../../report/schema/index.ts'

/** What a time step of an engine costs with one block on one ramp. */
export function engineTimes({ engineTests, engines }: Report) {
  return html`<div class="scroll" tabindex="0" role="region" aria-label="Engines, time, table">
    <table>
      <caption>
        One block slides down one ramp: time of a step, a call for each. Engines also turn, collide
        and stack; this project does only what the scene needs
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
        ${engineTests.times.map(({ engine, step, ratio }) => {
          const who = engines.find(({ id }) => id === engine)
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

/** How far each engine ends from the truth, under a clock of the reader's choice. */
export function engineErrors(
  { engineTests, engines }: Report,
  clock: string,
  choose: (clock: string) => void,
) {
  const tested = [...new Set(engineTests.runs.map(({ engine }) => engine))]
  const list = engineTests.clocks.map((id) => ({ id, label: id, about: `Frames: ${id}` }))
  return html`<label class="choose">
      Errors at
      ${menu({
        label: 'Frames of the engines’ errors',
        list,
        chosen: clock,
        pick: (id) => {
          choose(id)
          return true
        },
      })}
    </label>
    <div class="scroll" tabindex="0" role="region" aria-label="Engines, errors, table">
      <table>
        <caption>
          Distance from the true position at the end, at ${clock}
        </caption>
        <thead>
          <tr>
            <th scope="col">Engine</th>
            ${engineTests.scenes.map(
              ({ label, about }) => html`<th scope="col">${label}<small>${about}</small></th>`,
            )}
          </tr>
        </thead>
        <tbody>
          ${tested.map(
            (engine) =>
              html`<tr>
                <th scope="row">${engines.find(({ id }) => id === engine)?.label ?? engine}</th>
                ${engineTests.scenes.map(({ id }) =>
                  cell(
                    engineTests.runs.find(
                      (run) => run.engine === engine && run.scene === id && run.clock === clock,
                    ),
                  ),
                )}
              </tr>`,
          )}
        </tbody>
      </table>
    </div>`
}

function cell(run: EngineRun | undefined) {
  if (!run) return html`<td>–</td>`
  const { error, note } = run
  return html`<td title=${error === null ? '' : `${raw(error)} m`}>
    ${error === null ? 'no number any more' : roughMetres(withoutRounding(error, 1))}
    ${note ? html`<small>${note}</small>` : ''}
  </td>`
}

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
function time(nanoseconds: number, ratio?: number | null) {
  return html`<td title="${raw(nanoseconds)} ns">
    ${seconds(nanoseconds * 1e-9)}${ratio ? html`<small>${plain(ratio)} ×</small>` : ''}
  </td>`
}

function labelOf(list: readonly { id: string; label: string }[], id: string): string {
  return list.find((each) => each.id === id)?.label ?? id
}
