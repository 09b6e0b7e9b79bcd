import { html, nothing } from 'lit'
import type { PropertyDeclaration, PropertyValues } from 'lit'
import { ExperimentError } from '../physics/index.ts'
import type { Experiment, Problem } from '../physics/index.ts'
import { lessonOf } from '../lab/lesson.ts'
import { experimentOf } from '../lab/state/check.ts'
import { onSiteChange } from '../lab/site.ts'
import type { LabState } from '../lab/state/state.ts'
import { SlideLab } from '../panels/slideLab.ts'
import { stateAsked } from './attributes.ts'
import { Shadow, themeProblem } from './shadow.ts'

/** The properties that ask for something, by the names that `Asked` has for them. */
const asking = [
  ...(['experiment', 'scene', 'fps', 'integrator', 'stopping', 'timestep'] as const),
  'duration',
] as const

/** What else may be wrong. */
const others = ['locked', 'controls', 'hide', 'theme'] as const

/** A page that renders itself anew hands over an equal value as a new object: that asks for nothing. */
const byValue: PropertyDeclaration = {
  hasChanged: (value, before) => JSON.stringify(value) !== JSON.stringify(before),
}

/**
 * Blocks on a track, moved by different methods at different frame rates, beside the exact one.
 *
 * What is asked for by attribute or property, and can't be run, is told of above the lab and by the event `error`; the
 * lab goes on showing what it showed before.
 *
 * @tag slide-lab
 * @attr {JSON} experiment - An experiment as `simulate` takes it, or a list of up to eight that share scene, parameters
 * and duration.
 * @attr {string} scene - The id of a scene, as `run-out`.
 * @attr {string} fps - A frame rate for each block, as `10 30 120`.
 * @attr {string} integrator - The method of all blocks, as `velocity-verlet`.
 * @attr {string} stopping - The id of a stopping rule, as `located`.
 * @attr {string} timestep - The id of a timestep policy, as `fixed`; or JSON, with its options.
 * @attr {number} duration - How long each run lasts [s].
 * @attr {boolean} compact - Only the buttons, the picture and the transport, with a link to the whole lab.
 * @attr {boolean} locked - For a lesson: nothing can be used but playing and the time.
 * @attr {string} controls - For a lesson: what can be used besides playing and the time, and nothing else, as `angle fps`.
 * @attr {string} hide - For a lesson: what readers are to find out, `exact`, `spread` or both.
 * @attr {string} theme - `light` or `dark`, in the place of the page's own `color-scheme`.
 * @prop {Experiment | readonly Experiment[] | string | null} experiment - The same, as a value or as JSON.
 * @prop {string | null} scene
 * @prop {string | number | readonly number[] | null} fps
 * @prop {string | null} integrator
 * @prop {string | null} stopping
 * @prop {Experiment['timestep'] | string | null} timestep
 * @prop {number} duration - Setting it asks for another; reading it gives that of the runs shown [s].
 * @prop {boolean} compact
 * @prop {boolean} locked
 * @prop {string | null} controls
 * @prop {string | null} hide
 * @prop {string | null} theme
 * @readonly {readonly Experiment[]} experiments - What is run now, one for each block: as it was asked for, and as readers
 * changed it since. Fit to be set as `experiment`.
 * @readonly {readonly Trajectory[]} trajectories - The runs, as `simulate` returned them.
 * @readonly {Playback} playback - Its cursor on time: `time` [s], `speed`, `playing`, `play()`, `pause()`, `seek(time)`,
 * `toStart()`, `toEnd()`, `stepFrames(count)`.
 * @method {(options?: FocusOptions) => void} focus - Gives it the focus, and with it the keys: Space plays, ← → go by frames.
 * @fires {CustomEvent<{ experiments: readonly Experiment[] }>} change - What is run has become another, by the reader or
 * by the page. It bubbles and is composed.
 * @fires {CustomEvent<{ time: number }>} timeupdate - The instant shown has moved [s]; while it plays, as long as it can be
 * seen.
 * @fires {CustomEvent<{ message: string, problems: readonly Problem[] }>} error - What was asked for can't be run.
 * @slot caption - Shown below. All other content of the element is for browsers without scripts: it goes when the element
 * comes.
 * @csspart sheet - The card that all is on.
 * @csspart modes - The buttons that set all blocks at once.
 * @csspart spread - The frame-rate spread.
 * @csspart stage - The picture with its handles.
 * @csspart transport - Playing, the time slider and the strip of frames.
 * @csspart runners - The table of blocks.
 * @csspart parameters - The sliders of the scene.
 * @csspart plots - The curves over time.
 * @csspart link - The line below a compact one: what can be shared, and the link to the whole lab.
 * @csspart message - What was asked for and can't be run.
 * @cssprop --size - The text size that all other sizes go by; the reader's own, if nothing is said.
 * @cssprop --font-text, --font-controls - Typefaces: of large numbers and of letters in formulas, and of all else.
 * @cssprop --accent, --on-accent - What can be pressed and dragged, and what is written on it.
 * @cssprop --ink, --ink-soft - Text, and text of less weight.
 * @cssprop --paper, --sheet, --ground - Behind the card, the card, the ground under the track.
 * @cssprop --line, --edge - Lines between parts, and around what can be typed in.
 * @cssprop --shadow - Of the card.
 * @cssprop --wrong - What can't be run, and what has gone wrong.
 * @cssprop --runner-0, --runner-1, --runner-2, --runner-3, --runner-4, --runner-5, --runner-6, --runner-7 - The blocks.
 * @cssprop --force-gravity, --force-normal, --force-friction, --force-other, --force-sum, --velocity - The arrows on a block.
 */
export class SlideLabElement extends SlideLab {
  static override properties = {
    ...Object.fromEntries(asking.map((name) => [name, byValue])),
    duration: { noAccessor: true, hasChanged: () => true },
    ...SlideLab.properties,
    locked: { type: Boolean },
    controls: {},
    hide: {},
    theme: { reflect: true },
    problems: { state: true },
  }

  declare experiment: Experiment | readonly Experiment[] | string | null
  declare scene: string | null
  declare fps: string | number | readonly number[] | null
  declare integrator: string | null
  declare stopping: string | null
  declare timestep: string | Experiment['timestep'] | null
  declare locked: boolean
  declare controls: string | null
  declare hide: string | null
  declare theme: string | null
  declare private problems: readonly Problem[]
  readonly #shadow = new Shadow(this)
  #duration: unknown
  #refused: readonly Problem[] = []
  /** What the page has been told of, or had asked for itself at first. */
  #known: string | undefined
  #stopAskingSite = () => {}

  constructor() {
    super()
    this.problems = []
    // Vue takes `compact` alone for true only where it finds a boolean.
    this.compact = false
    this.locked = false
    this.playback.subscribe(this, 'write', () => {
      this.#tell('timeupdate', { time: this.playback.time })
    })
  }

  override get duration(): number {
    return super.duration
  }

  override set duration(value: number) {
    const before = this.#duration
    this.#duration = value
    this.requestUpdate('duration', before)
  }

  get experiments(): readonly Experiment[] {
    return experimentsOf(this.state)
  }

  override connectedCallback(): void {
    super.connectedCallback()
    // What its root has.
    this.removeAttribute('tabindex')
    this.#stopAskingSite = onSiteChange(() => this.requestUpdate())
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.#stopAskingSite()
  }

  override createRenderRoot(): HTMLElement {
    return this.#shadow.root
  }

  override focus(options?: FocusOptions): void {
    this.#shadow.root.focus(options)
  }

  override willUpdate(changed: PropertyValues): void {
    const isAsked = asking.some((name) => changed.has(name))
    if (isAsked) this.#refused = this.#ask()
    if (!isAsked && !others.some((name) => changed.has(name))) return
    const message = themeProblem(this.theme)
    const { lesson, problems } = lessonOf(this)
    this.lesson = lesson
    this.problems = [
      ...this.#refused,
      ...problems,
      ...(message ? [{ path: 'theme', message }] : []),
    ]
  }

  /** Runs what is asked for; if that can't be run, the problems with it are returned. */
  #ask(): readonly Problem[] {
    try {
      const state = stateAsked({
        ...Object.fromEntries(asking.map((name) => [name, this[name]])),
        duration: this.#duration,
      })
      // What is there already stays, with all that readers have done to it.
      if (JSON.stringify(experimentsOf(state)) !== JSON.stringify(this.experiments))
        this.open(state, '')
      return []
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      return error.problems
    }
  }

  override updated(changed: PropertyValues): void {
    super.updated(changed)
    this.#shadow.root.toggleAttribute('compact', this.compact)
    if (changed.has('simulated')) this.#tellChange()
    const { problems } = this
    if (changed.has('problems') && problems.length > 0)
      this.#tell('error', { message: new ExperimentError(problems).message, problems })
  }

  override render() {
    const { problems } = this
    const lines = problems.length > 0 ? new ExperimentError(problems).message.split('\n') : []
    return html`${
      lines.length > 0
        ? html`<div class="refusal" part="message" role="alert">
            <p>The page asks this lab for something that can’t be had, so that stays as it was.</p>
            <ul>
              ${lines.map((line) => html`<li>${line}</li>`)}
            </ul>
          </div>`
        : nothing
    }${super.render()}`
  }

  #tellChange(): void {
    const { experiments } = this
    const now = JSON.stringify(experiments)
    const before = this.#known
    this.#known = now
    if (before === undefined || before === now) return
    const detail = { experiments }
    this.dispatchEvent(new CustomEvent('change', { detail, bubbles: true, composed: true }))
  }

  #tell(type: string, detail: object): void {
    this.dispatchEvent(new CustomEvent(type, { detail }))
  }
}

function experimentsOf(state: LabState): readonly Experiment[] {
  return state.runners.map((runner) => experimentOf(state, runner))
}
