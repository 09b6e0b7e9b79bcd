import { html, LitElement, nothing } from 'lit'
import type { PropertyValues } from 'lit'
import { ExperimentError } from '../physics/index.ts'
import type { Trajectory } from '../physics/index.ts'
import { freshId } from '../ui/input.ts'
import type { AddressLink } from './addressLink.ts'
import { EarlyPress } from './earlyPress.ts'
import { allowed } from './labView.ts'
import type { LabView, Menus, OpenPanels, Panels } from './labView.ts'
import { modeButtons, sceneTabs } from './choices.ts'
import { LabHistory } from './labHistory.ts'
import type { Snapshot } from './labHistory.ts'
import { OpeningRun } from './openingRun.ts'
import { Playback } from './playback/playback.ts'
import { shortcut, transport } from './transport.ts'
import type { Lesson } from './lesson.ts'
import type { Preset } from './presets/preset.ts'
import { spreadNumber } from './spreadNumber.ts'
import { changed, refusal } from './state/change.ts'
import type { Change } from './state/change.ts'
import { undoGroupOf } from './state/history.ts'
import { opening } from './state/opening.ts'
import { Simulation } from './state/simulation.ts'
import type { Simulated } from './state/simulation.ts'
import type { LabState } from './state/state.ts'
import { tools } from './tools.ts'
import { describe } from './words.ts'

/** So long after the last change or frame, and so not while it plays, the picture is told in words [ms]. */
const PAUSE = 600

/**
 * The lab: blocks moved by different methods at different frame rates, beside the exact one. What it is loaded with later
 * is for its subclass to say.
 *
 * - attribute `linked`: keeps its state in the page's address; for one lab on a page
 * - attribute `compact`: only the buttons, the picture and the transport, and a link to the whole lab
 * - attribute `gliding`: it has it while blocks are on their way to where a button puts them
 * - `state`: what it shows, a plain value; setting it shows that, with everything run again
 * - `trajectories`: of every runner, as `simulate` returned them
 * - `playback`: its cursor on time
 */
export abstract class Lab extends LitElement implements LabView {
  static override properties = {
    compact: { type: Boolean },
    simulated: { state: true },
    preset: { state: true },
    selected: { state: true },
    problem: { state: true },
    spoken: { state: true },
    panels: { state: true },
    lesson: { state: true },
  }

  declare compact: boolean
  declare simulated: Simulated
  declare preset: Preset | undefined
  declare selected: number
  declare lesson: Lesson | undefined
  declare private problem: string
  /** The picture in words, as it was when it last came to rest. */
  declare private spoken: string
  /** Undefined until it is loaded. */
  declare private panels: Panels | undefined
  readonly playback = new Playback(this)
  readonly history = new LabHistory(this)
  private readonly openingRun = new OpeningRun(this, this.playback)
  private readonly earlyPress = new EarlyPress(this)
  private readonly simulation = new Simulation()
  private readonly sceneName = freshId('scene')
  private address: AddressLink | undefined
  private loading: Promise<void> | undefined
  private timer: ReturnType<typeof setTimeout> | undefined

  constructor() {
    super()
    this.selected = 0
    this.problem = ''
    this.state = opening
    this.spoken = describe(this.simulated, this.playback.time)
    this.playback.subscribe(this, 'write', this.tellLater)
    this.addEventListener('keydown', (event) => shortcut(event, this.playback))
  }

  get state(): LabState {
    return this.simulated.state
  }

  set state(state: LabState) {
    this.openingRun.end()
    this.panels?.glide.end()
    this.preset = undefined
    this.simulated = this.simulation.run(state)
    this.selected = Math.min(this.selected, state.runners.length - 1)
  }

  get menus(): Menus {
    return this.panels?.menus ?? { presets: [], engines: [] }
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
  }

  override createRenderRoot(): HTMLElement {
    // The still that stood for it.
    this.replaceChildren()
    return this
  }

  open(state: LabState, problem: string): void {
    const before = this.snapshot
    this.restored({ state, preset: undefined, problem })
    if (this.hasUpdated) this.history.add(before, this.snapshot)
  }

  restore(snapshot: Snapshot): void {
    this.restored(snapshot)
    this.address?.write(this.state)
  }

  readonly change = (change: Change): string => {
    const refused = this.lesson?.refusal(change)
    if (refused) return refused
    const before = this.snapshot
    const drawn = this.recorded.map(this.drawn)
    const isElsewhere = change.kind === 'scene' || change.kind === 'state'
    const preset = isElsewhere ? undefined : this.preset
    try {
      this.restore({ state: changed(this.state, change), preset, problem: '' })
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      return refusal(error, change, this.simulated.scene)
    }
    this.history.add(before, this.snapshot, undoGroupOf(change))
    if (isElsewhere) this.playback.toEnd()
    if (change.kind === 'mode') this.panels?.glide.begin(drawn, this.recorded)
    return ''
  }

  readonly load = (preset: Preset): void => {
    const before = this.snapshot
    const { state, problem } = preset.shown
    // What can't be run leaves the lab as it is, or at its opening, where the preset's note says what to see.
    const stays = problem !== '' && state !== opening
    this.restored({ state, problem, preset: stays ? before.preset : preset })
    this.history.add(before, this.snapshot)
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

  private get snapshot(): Snapshot {
    const { state, preset, problem } = this
    return { state, preset, problem }
  }

  private restored({ state, preset, problem }: Snapshot): void {
    this.state = state
    this.preset = preset
    this.problem = problem
  }

  protected override async scheduleUpdate(): Promise<void> {
    // An address that it begins with is read before anything is shown.
    if (!this.hasUpdated && location.hash.includes('=')) await this.link()
    await super.scheduleUpdate()
  }

  override firstUpdated(): void {
    const isLink = location.hash.includes('=')
    if (this.hasAttribute('linked') && !this.compact && !isLink)
      this.openingRun.playWhenSeen(
        this.querySelector('slide-stage')!,
        this.updateComplete.then(() => this.loading),
      )
  }

  override updated(changed: PropertyValues): void {
    this.tellLater()
    if (changed.has('compact') || !this.loading) this.loading = this.bring(this.compact)
  }

  /** A run as it is drawn, by its place among those that are visible. */
  private readonly drawn = (trajectory: Trajectory, i: number): Trajectory =>
    this.panels?.glide.drawn(trajectory, i) ?? trajectory

  private async link(): Promise<void> {
    if (!this.hasAttribute('linked')) return
    const { AddressLink } = await import('./addressLink.ts')
    this.address ??= new AddressLink(this)
  }

  /** Loads what a whole lab opens below its picture, or a compact one. */
  protected abstract loadPanels(isCompact: boolean): Promise<OpenPanels>

  /** The rest of the lab, as soon as its picture is there. */
  private async bring(isCompact: boolean): Promise<void> {
    const open = await this.loadPanels(isCompact)
    await this.link()
    if (isCompact !== this.compact) return
    this.panels?.glide.end()
    this.panels = open(this)
    await this.updateComplete
    this.earlyPress.repeat()
  }

  private readonly tellLater = (): void => {
    clearTimeout(this.timer)
    this.timer = setTimeout(() => {
      this.spoken = describe(this.simulated, this.playback.time, this.lesson?.hides('exact'))
    }, PAUSE)
  }

  override render() {
    const { simulated, playback, compact, panels, lesson } = this
    const { scene, exact, visible, state } = simulated
    const runners = visible.map(({ trajectory, name, state: { paletteIndex } }, i) => ({
      trajectory: this.drawn(trajectory, i),
      goal: trajectory,
      name,
      paletteIndex,
    }))
    const index = visible.indexOf(simulated.runners[this.selected]!)
    const selected = index < 0 ? undefined : index
    const { parameters, duration } = state
    const still = {
      ...{ scene, parameters, duration, runners, exact, selected },
      withoutExact: lesson?.hides('exact'),
      handles: lesson?.handles,
    }
    return html`
      ${(this.address ?? panels)?.refusal?.(this.problem)}
      <div class="sheet" part="sheet">
        ${
          compact || lesson?.locked
            ? nothing
            : html`<div class="masthead">
                ${allowed(this, 'scene', sceneTabs(this, this.sceneName))} ${tools(this)}
              </div>`
        }
        <div class="opening">
          ${allowed(this, 'modes', modeButtons(this))}${lesson?.hides('spread') ? nothing : spreadNumber(this, this.openingRun.counting)}
        </div>
        <div class="preset-note" role="status">${panels?.note?.()}</div>
        <slide-stage
          part="stage"
          .playback=${playback}
          .picture=${(time: number) => ({ ...still, time, forces: panels?.forces?.() })}
          .description=${this.spoken}
          .forceDrawing=${panels?.forceDrawing}
          .change=${(values: Readonly<Record<string, number>>) =>
            this.change({ kind: 'parameters', values })}
        ></slide-stage>
        ${transport(this)}
        ${panels?.below() ?? (compact ? nothing : html`<div class="room"></div>`)}
        <p class="visually-hidden" aria-live="polite">${this.spoken}</p>
      </div>
    `
  }
}
