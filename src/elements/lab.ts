import { html, nothing } from 'lit'
import type { PropertyValues } from 'lit'
import { ExperimentError } from '../physics/index.ts'
import type { Experiment, Problem } from '../physics/index.ts'
import { stateAsked } from '../figure/attributes.ts'
import { experimentOf } from '../figure/check.ts'
import { SlideLab } from '../figure/slideLab.ts'
import { rootIn } from './shadow.ts'

/** The properties that ask for something, by the names that `Asked` has for them. */
const asking = ['experiment', 'scene', 'fps', 'integrator', 'stopping', 'timestep'] as const

/** `<slide-lab>` for other people's pages: see `src/elements.ts` for what it offers. */
export class SlideLabElement extends SlideLab {
  static override properties = {
    ...SlideLab.properties,
    ...Object.fromEntries(asking.map((name) => [name, {}])),
    askedDuration: { attribute: 'duration' },
    problems: { state: true },
  }

  declare experiment: Experiment | readonly Experiment[] | string | null
  declare scene: string | null
  declare fps: string | number | readonly number[] | null
  declare integrator: string | null
  declare stopping: string | null
  declare timestep: string | Experiment['timestep'] | null
  declare private askedDuration: unknown
  declare private problems: readonly Problem[]

  constructor() {
    super()
    this.problems = []
    this.playback.watch(this, 'write', () => {
      this.tell('timeupdate', { time: this.playback.time })
    })
  }

  /** How long each run lasts [s]. */
  override get duration(): number {
    return super.duration
  }

  override set duration(value: number) {
    this.askedDuration = value
  }

  /** What is run now, one for each block: as it was asked for, and as readers changed it. */
  get experiments(): readonly Experiment[] {
    return this.state.runners.map((runner) => experimentOf(this.state, runner))
  }

  override connectedCallback(): void {
    super.connectedCallback()
    // What its root has, see rootIn.
    this.removeAttribute('tabindex')
  }

  override createRenderRoot() {
    return rootIn(this)
  }

  override focus(options?: FocusOptions): void {
    ;(this.renderRoot as HTMLElement).focus(options)
  }

  override willUpdate(changed: PropertyValues): void {
    if (!asking.some((name) => changed.has(name)) && !changed.has('askedDuration')) return
    try {
      this.open(stateAsked({ ...this.asked(), duration: this.askedDuration }), '')
      this.problems = []
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      this.problems = error.problems
    }
  }

  override updated(changed: PropertyValues): void {
    super.updated(changed)
    ;(this.renderRoot as HTMLElement).toggleAttribute('compact', this.compact)
    if (changed.get('simulated')) this.tell('change', { experiments: this.experiments })
    const { problems } = this
    if (changed.has('problems') && problems.length > 0)
      this.tell('error', { message: new ExperimentError(problems).message, problems })
  }

  override render() {
    const { problems } = this
    const lines = problems.length > 0 ? new ExperimentError(problems).message.split('\n') : []
    return html`${
      problems.length > 0
        ? html`<div class="link-problems" role="alert">
            <p>The page asks this lab for something that can’t be run, so it stays as it was.</p>
            <ul>
              ${lines.map((line) => html`<li>${line}</li>`)}
            </ul>
          </div>`
        : nothing
    }${super.render()}`
  }

  private asked() {
    return Object.fromEntries(asking.map((name) => [name, this[name]]))
  }

  private tell(type: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(type, { detail }))
  }
}
