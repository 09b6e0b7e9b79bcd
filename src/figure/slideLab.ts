import { html, LitElement, nothing } from 'lit'
import type { PropertyValues } from 'lit'
import { ExperimentError } from '../physics/index.ts'
import type { Trajectory } from '../physics/index.ts'
import { AddressLink } from './addressLink.ts'
import { atNow } from './atNow.ts'
import { burstOf } from './burst.ts'
import { ForcesSwitch } from './forcesSwitch.ts'
import { freshId } from './freshId.ts'
import { Glide } from './glide.ts'
import type { LabView } from './labView.ts'
import { stepInspector } from './inspector/stepInspector.ts'
import { linkProblems } from './linkProblems.ts'
import { modeButtons } from './modeButtons.ts'
import { opening } from './opening.ts'
import { refusal } from './refusal.ts'
import { parametersPanel } from './parametersPanel.ts'
import { Past } from './past.ts'
import type { Moment } from './past.ts'
import { Playback } from './playback.ts'
import type { Preset } from './presets/preset.ts'
import { presetNote } from './presets/presetNote.ts'
import { runnersTable } from './runnersTable.ts'
import { sceneTabs } from './sceneTabs.ts'
import { openInLab } from './share/openInLab.ts'
import { shortcut } from './shortcuts.ts'
import { Simulation } from './simulation.ts'
import type { Simulated } from './simulation.ts'
import { spreadFigure } from './spreadFigure.ts'
import { changed } from './state.ts'
import type { Change, LabState } from './state.ts'
import { tools } from './tools.ts'
import { transport } from './transport.ts'
import { describe } from './words.ts'

/** So long after the last change or frame, and so not while it plays, the picture is told in words [ms]. */
const PAUSE = 600

/**
 * The lab: blocks moved by different methods at different frame rates, beside the exact one.
 *
 * - attribute `linked`: keeps its state in the page's address; for one lab on a page
 * - attribute `compact`: only the buttons, the picture and the transport, and a link to the whole lab
 * - attribute `gliding`: it has it while blocks are on their way to where a button puts them
 * - `state`: what it shows, a plain value; setting it shows that, with everything run again
 * - `trajectories`: of every runner, as `simulate` returned them
 * - `playback`: its cursor on time
 */
export class SlideLab extends LitElement implements LabView {
  static override properties = {
    compact: { type: Boolean },
    simulated: { state: true },
    preset: { state: true },
    selected: { state: true },
    linkProblem: { state: true },
    spoken: { state: true },
  }

  declare compact: boolean
  declare simulated: Simulated
  declare preset: Preset | undefined
  declare selected: number
  declare private linkProblem: string
  /** The picture in words, as it was when it last came to rest. */
  declare private spoken: string
  readonly playback = new Playback(this)
  readonly past = new Past(this)
  private readonly glide = new Glide(this)
  private readonly forces = new ForcesSwitch(this)
  private readonly simulation = new Simulation()
  private readonly sceneName = freshId('scene')
  private address: AddressLink | undefined
  private timer: ReturnType<typeof setTimeout> | undefined

  constructor() {
    super()
    this.selected = 0
    this.linkProblem = ''
    this.state = opening
    this.spoken = describe(this.simulated, this.playback.time)
    this.playback.watch(this, 'write', this.tellLater)
    this.addEventListener('keydown', (event) => shortcut(event, this.playback))
  }

  get state(): LabState {
    return this.simulated.state
  }

  set state(state: LabState) {
    this.glide.end()
    this.preset = undefined
    this.simulated = this.simulation.run(state)
    this.selected = Math.min(this.selected, state.runners.length - 1)
  }

  get trajectories(): readonly Trajectory[] {
    return this.simulated.runners.map(({ trajectory }) => trajectory)
  }

  get duration(): number {
    return this.state.duration
  }

  get recorded(): readonly Trajectory[] {
    return this.simulated.visible.map(({ trajectory }) => trajectory)
  }

  override connectedCallback(): void {
    super.connectedCallback()
    // A click anywhere in it gives it the focus, and with it the keys.
    this.tabIndex = -1
    if (this.hasAttribute('linked')) this.address ??= new AddressLink(this)
  }

  override createRenderRoot(): HTMLElement {
    // The still that stood for it.
    this.replaceChildren()
    return this
  }

  open(state: LabState, problem: string): void {
    const before = this.moment
    this.restored({ state, preset: undefined, problem })
    if (this.hasUpdated) this.past.add(before, this.moment)
  }

  restore(moment: Moment): void {
    this.restored(moment)
    this.address?.write(this.state)
  }

  readonly change = (change: Change): string => {
    const before = this.moment
    const drawn = this.recorded.map((trajectory, i) => this.glide.drawn(trajectory, i))
    const preset = change.kind === 'scene' ? undefined : this.preset
    try {
      this.restore({ state: changed(this.state, change), preset, problem: '' })
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      return refusal(error, change, this.simulated.scene)
    }
    this.past.add(before, this.moment, burstOf(change))
    if (change.kind === 'scene') this.playback.toEnd()
    if (change.kind === 'mode') this.glide.begin(drawn, this.recorded)
    return ''
  }

  readonly load = (preset: Preset): void => {
    const before = this.moment
    this.restored({ ...preset.shown, preset })
    this.past.add(before, this.moment)
    this.playback.toEnd()
    this.address?.push(this.state)
  }

  readonly dismiss = (): void => {
    this.preset = undefined
    this.focus()
  }

  readonly select = (index: number): void => {
    this.selected = index
  }

  private get moment(): Moment {
    const { state, preset, linkProblem } = this
    return { state, preset, problem: linkProblem }
  }

  private restored({ state, preset, problem }: Moment): void {
    this.state = state
    this.preset = preset
    this.linkProblem = problem
  }

  override updated(_changed: PropertyValues): void {
    this.tellLater()
  }

  private readonly tellLater = (): void => {
    clearTimeout(this.timer)
    this.timer = setTimeout(() => {
      this.spoken = describe(this.simulated, this.playback.time)
    }, PAUSE)
  }

  override render() {
    const { simulated, playback, compact } = this
    const { scene, exact, visible, state } = simulated
    const runners = visible.map(({ trajectory, name, state: { look } }, i) => ({
      trajectory: this.glide.drawn(trajectory, i),
      goal: trajectory,
      name,
      look,
    }))
    const { parameters, duration } = state
    const still = { scene, parameters, duration, runners, exact }
    return html`
      ${linkProblems(this.linkProblem)}
      <div class="sheet">
        ${
          compact
            ? nothing
            : html`<div class="masthead">${sceneTabs(this, this.sceneName)} ${tools(this)}</div>`
        }
        <div class="opening">${modeButtons(this)} ${spreadFigure(this)}</div>
        ${presetNote(this)}
        <slide-stage
          .playback=${playback}
          .picture=${(time: number) => ({ ...still, time, ...this.forces.picture() })}
          .description=${this.spoken}
          .change=${(values: Readonly<Record<string, number>>) =>
            this.change({ kind: 'parameters', values })}
        ></slide-stage>
        ${transport(this)} ${compact ? openInLab(state) : this.instruments()}
        <p class="visually-hidden" aria-live="polite">${this.spoken}</p>
      </div>
    `
  }

  private instruments() {
    const { simulated, playback } = this
    return html`${this.forces.panel()} ${parametersPanel(this)} ${runnersTable(this)}
      <lab-plots
        .simulated=${simulated}
        .time=${atNow(playback, (time) => time)}
        .selected=${this.selected}
        .seek=${(time: number) => playback.seek(time)}
      ></lab-plots>
      <lab-measures .simulated=${simulated} .selected=${this.selected} .lab=${this}></lab-measures>
      ${stepInspector(this)}`
  }
}
