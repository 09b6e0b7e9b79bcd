import { LitElement } from 'lit'
import type { PropertyValues } from 'lit'
import type { Trajectory } from '../../physics/index.ts'
import { onNear } from '../../ui/visibility.ts'
import { Playback } from '../../lab/playback/playback.ts'
import { RunCache } from '../../lab/state/runCache.ts'
import { figures } from '../index.ts'
import type { ControlValues } from '../shared/control.ts'
import type { Figure } from '../shared/figure.ts'
import type { Live } from './live.ts'

/** So long after the last change or frame the outcome is told to those who can't see it [ms]. */
const PAUSE = 600

/**
 * A live figure of the tutorial. Until it comes near the window it is what stands in it, a still of the same size.
 *
 * - attribute `name`: which figure, one of `figures/index.ts`
 * - attribute `live`: it has it as soon as it is alive
 * - `values`: of its controls, by name; empty until it is alive
 * - `set(values)`: changes some of them, numbers or the text of an address; one that is not alive yet comes alive first.
 *   Throws RangeError for a control or a value that there is not
 * - `lit`: the arrow to set off from the others, `gravity`, `normal`, `friction`, `sum` or `velocity`; undefined for none
 * - `trajectories`: what it shows, as `simulate` returned them
 * - `playback`: its cursor on time
 * - event `change`, with the values as `detail`: after every change, by the reader or by `set`
 */
export class SlideFigure extends LitElement {
  static override properties = {
    name: {},
    lit: { attribute: false },
    view: { state: true },
    spoken: { state: true },
  }

  declare name: string
  declare lit: string | undefined
  /** What is shown; undefined until it is alive. */
  declare view: { readonly values: ControlValues; readonly runs: readonly Trajectory[] } | undefined
  /** The outcome as it was when all last came to rest. */
  declare spoken: string
  readonly playback = new Playback(this)
  private figure: Figure | undefined
  private live: Live | undefined
  private hosted: HTMLElement | undefined
  private waking: Promise<void> | undefined
  private asked: Record<string, unknown> = {}
  private readonly cache = new RunCache()
  private timer: ReturnType<typeof setTimeout> | undefined
  private stopWatching = () => {}

  constructor() {
    super()
    this.spoken = ''
    this.playback.subscribe(this, 'write', () => this.tellLater())
  }

  get values(): ControlValues {
    return this.view?.values ?? {}
  }

  /** Of the figure, once it is alive. */
  protected get controlNames(): readonly string[] {
    return Object.keys(this.figure?.controls ?? {})
  }

  get trajectories(): readonly Trajectory[] {
    return this.view?.runs ?? []
  }

  get duration(): number {
    const { figure, view } = this
    return (view && figure?.duration?.(view.values)) ?? 0
  }

  get recorded(): readonly Trajectory[] {
    return this.trajectories
  }

  readonly set = (given: Readonly<Record<string, unknown>>): void => {
    const { live, figure, view } = this
    if (!live || !figure || !view) {
      this.asked = { ...this.asked, ...given }
      void this.wake()
      return
    }
    this.show(live.follow(figure, given, view.values))
    this.tellLater()
    const detail = this.values
    this.dispatchEvent(new CustomEvent('change', { detail, bubbles: true, composed: true }))
  }

  override connectedCallback(): void {
    super.connectedCallback()
    this.stopWatching = onNear(this, (isNear) => {
      if (isNear) void this.wake()
    })
  }

  /** If it has come near, it comes alive again: as what it is called by now. */
  protected wakeAnew(): void {
    if (!this.waking) return
    this.waking = undefined
    this.asked = {}
    void this.wake()
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
    clearTimeout(this.timer)
  }

  /** Whether readers may use a control. */
  protected may = (_control: string): boolean => true

  /** Whether a part is kept from readers. */
  protected hides = (_part: 'readings' | 'outcome'): boolean => false

  override createRenderRoot(): HTMLElement {
    return this
  }

  override shouldUpdate(_changed: PropertyValues): boolean {
    return this.live !== undefined
  }

  override render() {
    const { live, figure, view, playback, spoken, hosted, lit, set, may, hides } = this
    const parts = { playback, spoken, hosted, lit, set, may, hides }
    return live!.face({ figure: figure!, ...view!, ...parts })
  }

  private wake(): Promise<void> {
    return (this.waking ??= this.comeAlive().catch((error: unknown) => {
      // What could not be loaded is asked for again when it comes near the next time.
      this.waking = undefined
      throw error
    }))
  }

  protected async comeAlive(): Promise<void> {
    const entry = figures.find(({ id }) => id === this.name)
    if (!entry) {
      const known = figures.map(({ id }) => id).join(', ')
      throw new RangeError(`There is no figure “${this.name ?? ''}”. There are: ${known}.`)
    }
    const [{ live }, figure] = await Promise.all([import('./live.ts'), entry.load()])
    this.hosted = await live.hostedElement(figure)
    if (this.name !== entry.id) return
    const asked = this.asked
    this.figure = figure
    this.live = live
    const root = this.renderRoot as HTMLElement
    root.style.cssText = live.frameOf(figure)
    root.role = 'group'
    root.ariaLabel = figure.title
    this.show(live.initialValues(figure.controls))
    if (figure.opensAtStart) this.playback.toStart()
    // The still goes in the same turn in which the live picture comes.
    if (!this.hasUpdated) root.replaceChildren()
    root.toggleAttribute('live', true)
    if (Object.keys(asked).length > 0) this.set(asked)
  }

  private show(values: ControlValues): void {
    this.view = { values, runs: this.cache.run(this.figure!.experiments(values)) }
  }

  private tellLater(): void {
    clearTimeout(this.timer)
    this.timer = setTimeout(() => {
      const { figure, view, playback } = this
      if (figure && view) this.spoken = figure.says(view.values, view.runs, playback.time)
    }, PAUSE)
  }
}
