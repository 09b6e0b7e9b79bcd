import { html, LitElement, nothing } from 'lit'
import { frameClocks, integrators, stoppings, timesteps } from '../../physics/index.ts'
import type { Described, Options } from '../../physics/index.ts'
import { engines } from '../../engines/index.ts'
import { count, shownNumber } from '../../chart/numbers.ts'
import { rowAt } from '../../view/timeline.ts'
import { icon } from '../../ui/icons.ts'
import { menu } from '../../ui/menu.ts'
import '../../ui/runnerMark.ts'
import type { LabView } from '../../lab/labView.ts'
import { ofEngine } from '../../lab/lesson.ts'
import { atNow } from '../../lab/playback/atNow.ts'
import { choose } from '../../lab/state/choose.ts'
import { MOST_RUNNERS } from '../../lab/state/check.ts'
import type { DraftRunner } from '../../lab/state/check.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'
import { optionFields } from './optionFields.ts'
import { endText, errorText } from './results.ts'

/** What the menu of engines offers: none, or one of them. */
const engineList = [
  { id: '', label: 'none', about: 'Integrator, stopping and time step are your own choice' },
  ...engines.map(({ label, does }) => ({ id: label, label, about: does })),
]

/**
 * A runner's row: what can be set on it, and how wrong it is.
 *
 * - `lab`: what it belongs to
 * - `runner`, `index`: which one it is
 * - `selected`: whether it is the one that is looked at closely
 */
class RunnerRow extends LitElement {
  static override properties = {
    lab: { attribute: false },
    runner: { attribute: false },
    index: { attribute: false },
    count: { attribute: false },
    selected: { type: Boolean, reflect: true },
    problem: { state: true },
  }

  declare lab: LabView
  declare runner: SimulatedRunner
  declare index: number
  declare count: number
  declare selected: boolean
  declare private problem: string

  constructor() {
    super()
    this.problem = ''
  }

  override createRenderRoot(): this {
    return this
  }

  override render() {
    const { runner, problem } = this
    const { state, name } = runner
    return html`
      <div
        class="runner"
        role="group"
        aria-label=${name}
        ?data-hidden=${state.hidden}
        .style="--colour: var(--runner-${state.paletteIndex})"
        @focusin=${this.select}
        @pointerdown=${this.select}
        @change=${this.select}
      >
        ${this.mark()} ${this.rate()} ${this.clock()}
        ${this.choice('integrator', 'Integrator', integrators)}
        ${this.choice('stopping', 'Stopping', stoppings)} ${this.engine()} ${this.timestep()}
        ${this.errorNow()} ${this.errorAtEnd()} ${this.stopped()} ${this.evaluations()}
        ${this.actions()}
        ${problem ? html`<p class="problem" role="alert">${problem}</p>` : nothing}
      </div>
    `
  }

  private may(control: string): boolean {
    return this.lab.lesson?.may(control) !== false
  }

  private mark() {
    const { paletteIndex, hidden } = this.runner.state
    return html`<span class="mark"
      ><slide-runner-mark .paletteIndex=${paletteIndex} .hollow=${hidden}></slide-runner-mark
    ></span>`
  }

  private rate() {
    const { frames } = this.runner.state
    const text = 'fps' in frames ? `${shownNumber(frames.fps)} fps` : nothing
    return html`<div class="cell rate">
      ${this.may('fps') ? this.options('frames', frameClocks, true) : text}
    </div>`
  }

  private clock() {
    const { frames } = this.runner.state
    const pick = (kind: string) => this.set({ frames: choose('frames', kind, frames) })
    return this.cell('Frames', 'clock', frameClocks, frames.kind, pick, [
      this.options('frames', frameClocks, false),
    ])
  }

  private timestep() {
    const { timestep } = this.runner.state
    const pick = (kind: string) => this.set({ timestep: choose('timestep', kind, timestep) })
    return this.cell('Time step', 'timestep', timesteps, timestep.kind, pick, [
      this.options('timestep', timesteps),
    ])
  }

  /** A menu of engines, each of which sets integrator, stopping and time step. */
  private engine() {
    const { engine: chosen = '' } = this.runner.state
    if (!ofEngine.every((each) => this.may(each))) return nothing
    const pick = (label: string) => {
      const engine = engines.find((each) => each.label === label)
      return this.set({ ...engine?.method, engine: engine?.label })
    }
    return html`<div class="cell engine choice">
      <span aria-hidden="true">Engine</span>
      ${menu({ label: `Engine, ${this.runner.name}`, list: engineList, chosen, pick })}
    </div>`
  }

  private choice(key: 'integrator' | 'stopping', label: string, list: readonly Described[]) {
    const pick = (id: string) => this.set({ [key]: id })
    return this.cell(label, key, list, this.runner.state[key], pick)
  }

  private cell(
    label: string,
    name: string,
    list: readonly Described[],
    chosen: string,
    pick: (id: string) => boolean,
    options: readonly unknown[] = [],
  ) {
    const may = this.may(name === 'clock' ? 'frames' : name)
    const text = list.find(({ id }) => id === chosen)!.label
    return html`<div class="cell ${name}">
      <span class="cell-label" aria-hidden="true">${label}</span>
      ${
        may
          ? html`${menu({ label: `${label}, ${this.runner.name}`, list, chosen, pick })} ${options}`
          : html`<span class="visually-hidden">${label}: </span>${text}`
      }
    </div>`
  }

  /** The options of the clock or the timestep: the frame rate alone, or all but it, or all. */
  private options(
    of: 'frames' | 'timestep',
    list: readonly (Described & { readonly options: Options })[],
    rate?: boolean,
  ) {
    const chosen = this.runner.state[of]
    const { options } = list.find(({ id }) => id === chosen.kind)!
    const shown = Object.entries(options).filter(
      ([key]) => rate === undefined || (key === 'fps') === rate,
    )
    return optionFields({
      of: this.runner.name,
      options: Object.fromEntries(shown),
      values: { ...chosen },
      pick: (key, value) => {
        const problem = this.lab.change({ kind: 'option', index: this.index, of, key, value })
        // A number's field says so itself.
        if (options[key]!.type !== 'number') this.problem = problem
        return problem
      },
    })
  }

  private errorNow() {
    const { simulated, playback } = this.lab
    const { trajectory } = this.runner
    let row = -1
    let error = { text: '', title: '' }
    if (this.lab.lesson?.hides('exact')) return this.result('Error now', 'now', '–', nothing)
    const at = (time: number) => {
      const next = rowAt(trajectory, time)
      if (next !== row) error = errorText(simulated, trajectory, (row = next))
      return error
    }
    const text = atNow(playback, (time) => at(time).text)
    const title = atNow(playback, (time) => at(time).title)
    return this.result('Error now', 'now', text, title)
  }

  private errorAtEnd() {
    const { trajectory } = this.runner
    if (this.lab.lesson?.hides('exact')) return this.result('Error at the end', 'end', '–', nothing)
    const { text, title } = errorText(this.lab.simulated, trajectory, trajectory.frames)
    return this.result('Error at the end', 'end', text, title)
  }

  private stopped() {
    const { text, title } = endText(this.runner.trajectory)
    return this.result('Stopped', 'stopped', text, title)
  }

  private evaluations() {
    const { evaluations, steps } = this.runner.trajectory
    const title = `The forces were looked at ${evaluations} times, in ${steps} steps`
    return this.result('Evaluations', 'evaluations', count(evaluations), title)
  }

  private result(label: string, name: string, text: unknown, title: unknown) {
    return html`<div class="cell result ${name}">
      <span class="cell-label">${label}</span><output title=${title}>${text}</output>
    </div>`
  }

  private actions() {
    const { count, runner } = this
    const { hidden } = runner.state
    if (!this.may('runners')) return nothing
    return html`<div class="actions">
      <button
        type="button"
        class="eye"
        title=${hidden ? 'Show' : 'Hide'}
        aria-label="${hidden ? 'Show' : 'Hide'} ${runner.name}"
        @click=${() => this.set({ hidden: !hidden })}
      >
        ${icon(hidden ? 'closedEye' : 'eye')}
      </button>
      <button
        type="button"
        title="Duplicate"
        aria-label="Duplicate ${runner.name}"
        ?disabled=${count >= MOST_RUNNERS}
        @click=${this.duplicate}
      >
        ${icon('duplicate')}
      </button>
      <button
        type="button"
        title="Remove"
        aria-label="Remove ${runner.name}"
        ?disabled=${count <= 1}
        @click=${this.leave}
      >
        ${icon('remove')}
      </button>
    </div>`
  }

  private readonly duplicate = (): void => {
    this.lab.change({ kind: 'duplicate', index: this.index })
    // The button of the last that there is room for can't keep the focus.
    if (this.count + 1 >= MOST_RUNNERS) this.querySelector<HTMLElement>('.eye')!.focus()
  }

  private readonly leave = (): void => {
    const { nextElementSibling: next, previousElementSibling: previous } = this
    const neighbour = next instanceof RunnerRow ? next : previous
    this.lab.change({ kind: 'remove', index: this.index })
    // The focus stays among the runners.
    neighbour?.querySelector<HTMLElement>('.eye')?.focus()
    // It has moved up, but does not know its new place yet.
    this.lab.select(Math.min(this.index, this.count - 2))
  }

  private readonly select = (): void => this.lab.select(this.index)

  /** Whether it could be set so. */
  private set(values: Partial<DraftRunner>): boolean {
    this.problem = this.lab.change({ kind: 'runner', index: this.index, values })
    return this.problem === ''
  }
}

customElements.define('slide-runner-row', RunnerRow)
