import { html, LitElement, nothing } from 'lit'
import { fixed } from '../../chart/numbers.ts'
import { segments } from '../../ui/segments.ts'
import '../../ui/runnerMark.ts'
import type { Playback } from '../../lab/playback/playback.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import { plotKinds, plotsOf } from './kinds.ts'
import './labPlot.ts'

/**
 * All plots of a lab: side by side where there is room, one at a time on a phone. They share one cursor with each other
 * and with the transport.
 *
 * - `simulated`: what they show
 * - `withoutExact`: the exact block is not to be seen
 * - `time`: of the transport, as it is read [s]; `playback`: the same at every frame
 * - `selected`: the index of the runner that is looked at closely
 * - `seek`: called with the time that the reader goes to
 */
class LabPlots extends LitElement {
  static override properties = {
    simulated: { attribute: false },
    withoutExact: { attribute: false },
    time: { attribute: false },
    selected: { attribute: false },
    hover: { state: true },
    chosen: { state: true },
  }

  declare simulated: Simulated
  declare withoutExact: boolean
  declare time: number
  /** Not reactive: it is the same for good. */
  declare playback: Playback
  declare selected: number
  /** Not reactive: a fresh closure is no reason to draw again. */
  declare seek: (time: number) => void
  declare private hover: number | undefined
  /** Which plot stands where there is room for one. */
  declare private chosen: string

  constructor() {
    super()
    this.chosen = plotKinds[0]!.id
  }

  override createRenderRoot(): this {
    return this
  }

  override render() {
    const { simulated, hover } = this
    const kinds = plotsOf(simulated, this.withoutExact)
    const { id: chosen } = kinds.find(({ id }) => id === this.chosen) ?? kinds[0]!
    const time = hover ?? this.time
    return html`<section class="plots">
      <header>
        <h2>Plots</h2>
        <ul class="key">
          ${simulated.visible.map(
            ({ name, state }) =>
              html`<li>
                <slide-runner-mark .paletteIndex=${state.paletteIndex}></slide-runner-mark> ${name}
              </li>`,
          )}
          ${
            this.withoutExact
              ? nothing
              : html`<li><span class="dash" aria-hidden="true"></span> exact</li>`
          }
        </ul>
        <p class="instant">
          ${hover === undefined ? 'values at' : 'values under the pointer, at'}
          <span .style="width: ${fixed(simulated.state.duration, 3).length + 1}ch"
            >${fixed(time, 3)} s</span
          >
        </p>
      </header>
      ${segments({
        label: 'Which plot',
        list: kinds.map(({ id, title }) => ({ id, label: title })),
        chosen,
        pick: ({ id }) => (this.chosen = id),
      })}
      <div class="multiples">
        ${kinds.map(
          (kind) =>
            html`<slide-lab-plot
              ?data-chosen=${kind.id === chosen}
              data-plot=${kind.id}
              .kind=${kind}
              .simulated=${simulated}
              .time=${this.time}
              .playback=${this.playback}
              .hover=${hover}
              .selected=${this.selected}
              .seek=${this.seek}
              .point=${this.point}
            ></slide-lab-plot>`,
        )}
      </div>
    </section>`
  }

  private readonly point = (time: number | undefined): void => {
    this.hover = time
  }
}

customElements.define('slide-lab-plots', LabPlots)
