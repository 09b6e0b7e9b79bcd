import { html, nothing } from 'lit'
import { repeat } from 'lit/directives/repeat.js'
import { frameClocks, integrators, stoppings, timesteps } from '../../physics/index.ts'
import { engines } from '../../engines/index.ts'
import type { Described } from '../../physics/index.ts'
import { allowed } from '../../lab/labView.ts'
import type { LabView } from '../../lab/labView.ts'
import { MOST_RUNNERS } from '../../lab/state/check.ts'
import { measuredDelta } from './measuredDelta.ts'
import './runnerRow.ts'

const headings = [
  ...['Frame rate', 'Frames', 'Integrator', 'Stopping', 'Time step'],
  ...['Error now', 'Error at the end', 'Stopped', 'Evaluations'],
]

/** A row for each runner, and what the choices of the selected one mean. */
export function runnersTable(lab: LabView) {
  const { runners } = lab.simulated
  return html`<section class="runners" part="runners">
    <h2>Runners</h2>
    <div class="runner headings" aria-hidden="true">
      ${headings.map((heading) => html`<span>${heading}</span>`)}
    </div>
    ${repeat(
      runners,
      ({ state }) => state.paletteIndex,
      (runner, index) =>
        html`<slide-runner-row
          .lab=${lab}
          .runner=${runner}
          .index=${index}
          .count=${runners.length}
          .selected=${index === lab.selected}
        ></slide-runner-row>`,
    )}
    ${allowed(
      lab,
      'runners',
      html`<button
        type="button"
        class="add"
        ?disabled=${runners.length >= MOST_RUNNERS}
        @click=${(event: Event) => add(lab, event.currentTarget as HTMLElement)}
      >
        Add a runner
      </button>`,
    )}
    ${allowed(
      lab,
      'frames',
      html`<slide-record-frames
          .lab=${lab}
          .selected=${runners[lab.selected]?.name ?? ''}
        ></slide-record-frames>
        <slide-open-log
          .lab=${lab}
          .selected=${runners[lab.selected]?.name ?? ''}
        ></slide-open-log>`,
    )}
    ${notes(lab)}
  </section>`
}

/** The button of the last that there is room for hands the focus on to the runners, since it can't keep it. */
function add(lab: LabView, button: HTMLElement): void {
  lab.change({ kind: 'add' })
  if (lab.simulated.runners.length < MOST_RUNNERS) return
  const eyes = button.parentElement!.querySelectorAll<HTMLElement>('.eye')
  eyes[eyes.length - 1]!.focus()
}

function notes(lab: LabView) {
  const { simulated, selected } = lab
  const runner = simulated.runners[selected]
  if (!runner) return ''
  const { integrator, stopping, timestep, frames, engine } = runner.state
  const its = engines.find(({ label }) => label === engine)
  return html`<dl class="notes" .style="--colour: var(--runner-${runner.state.paletteIndex})">
    ${note(integrators, integrator)} ${note(stoppings, stopping)} ${note(timesteps, timestep.kind)}
    ${note(frameClocks, frames.kind)} ${allowed(lab, 'frames', measuredDelta(lab))}
    ${
      its
        ? html`<div class="engine">
            <dt>${its.label}</dt>
            <dd>${its.does} ${its.leavesOut} Source: ${its.source}.</dd>
          </div>`
        : nothing
    }
  </dl>`
}

function note(list: readonly Described[], chosen: string) {
  const { label, about } = list.find(({ id }) => id === chosen)!
  return html`<div>
    <dt>${label}</dt>
    <dd>${about}</dd>
  </div>`
}
