import { html, LitElement, nothing } from 'lit'
import { integrators, scenes, stoppings, timesteps } from '../../physics/index.ts'
import type { Experiment, SceneId } from '../../physics/index.ts'
import { spreadMethods } from '../../measure/index.ts'
import type { Method, Spread, SpreadRequest, SpreadRow } from '../../measure/index.ts'
import { sizeText } from '../../chart/magnitudes.ts'
import { menu } from '../../ui/menu.ts'
import { choose } from '../../lab/state/choose.ts'
import { openingOf } from '../../lab/state/opening.ts'
import { spreadText } from '../../lab/state/spreadText.ts'
import type { LabState } from '../../lab/state/state.ts'
import { Measuring, progress } from './measuring.ts'
import { sharedExperiment } from './sharedExperiment.ts'

/**
 * The frame-rate spread of every method in every scene, measured while it can be seen.
 *
 * - `state`: of the lab; its own scene is measured with its parameters, the others as they open
 * - `load`: called with a scene and a method that the reader wants to see
 */
class SpreadView extends LitElement {
  static override properties = {
    state: { attribute: false },
    stopping: { state: true },
    timestep: { state: true },
  }

  declare state: LabState
  /** Not reactive: a fresh closure is no reason to draw again. */
  declare load: (scene: SceneId, method: Method, label: string, words: string) => void
  declare private stopping: Method['stopping']
  declare private timestep: Method['timestep']
  private rows = new Map<number, readonly Spread[]>()
  private readonly measuring: Measuring = new Measuring(this, (_, parts, fresh) => {
    if (fresh) this.rows = new Map()
    for (const part of parts as SpreadRow[]) this.rows.set(part.row, part.spreads)
  })

  constructor() {
    super()
    this.stopping = 'located'
    this.timestep = { kind: 'variable' }
  }

  override createRenderRoot(): this {
    return this
  }

  override willUpdate(): void {
    this.measuring.want({ kind: 'spreads', request: this.request })
  }

  private get request(): SpreadRequest {
    const experiments = scenes.map(({ id }) => {
      const { scene, parameters, duration } = id === this.state.scene ? this.state : openingOf(id)
      return sharedExperiment({ scene, parameters, duration } as Experiment)
    })
    return {
      experiments,
      methods: spreadMethods({ stopping: this.stopping, timestep: this.timestep }),
    }
  }

  override render() {
    const { stopping, timestep, measuring } = this
    const { methods } = this.request
    return html`<div class="measure" ?data-busy=${measuring.busy}>
      <div class="measure-controls">
        <label class="choose">
          Stops
          ${menu({
            label: 'Stopping rule of the table',
            list: stoppings,
            chosen: stopping,
            pick: (id) => {
              this.stopping = id
              return true
            },
          })}
        </label>
        <label class="choose">
          Time step
          ${menu({
            label: 'Time step of the table',
            list: timesteps,
            chosen: timestep.kind,
            pick: (id) => {
              this.timestep = choose('timestep', id, timestep)
              return true
            },
          })}
        </label>
        ${progress(measuring)}
      </div>
      <div class="scroll" tabindex="0" role="region" aria-label="Frame-rate spread, table">
        <table class="spreads">
          <caption>
            How far apart runs end at 5 to 240 steady frames a second, with jitter and with hitches
          </caption>
          <thead>
            <tr>
              <td></td>
              ${scenes.map(
                ({ id, label }) =>
                  html`<th scope="col">
                    ${label}${id === this.state.scene ? html`<small>as in the lab</small>` : nothing}
                  </th>`,
              )}
            </tr>
          </thead>
          <tbody>
            ${methods.map((method, row) => this.row(method, row))}
          </tbody>
        </table>
      </div>
    </div>`
  }

  private row(method: Method, row: number) {
    const integrator = integrators.find(({ id }) => id === method.integrator)!.label
    const name = row === 0 ? 'The paper’s own step' : integrator
    const spreads = this.rows.get(row)
    return html`<tr>
      <th scope="row">
        ${name}${row === 0 ? html`<small>${integrator}, naive stops</small>` : nothing}
      </th>
      ${scenes.map(({ id, label }, column) => {
        const spread = spreads?.[column]
        if (spread === undefined) return html`<td>…</td>`
        const { value, remark, title, exact } = spreadText(spread, sizeText)
        const text = remark ? `${value} (${remark})` : value
        return html`<td ?data-exact=${exact}>
          <button
            type="button"
            class="in-text"
            title="${title}. Click to see it in the lab."
            aria-label="${name}, ${label}: ${text}. Show it in the lab"
            @click=${() => this.load(id, method, `${name}, ${label.toLowerCase()}`, `Its frame-rate spread, from 5 to 240 fps: ${text}.`)}
          >
            ${value}${remark ? html` <small>(${remark})</small>` : nothing}
          </button>
        </td>`
      })}
    </tr>`
  }
}

customElements.define('slide-spread-view', SpreadView)
