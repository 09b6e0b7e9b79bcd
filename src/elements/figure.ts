import { html, nothing } from 'lit'
import type { PropertyValues } from 'lit'
import { SlideFigure } from '../figures/element/slideFigure.ts'
import type { ControlValues } from '../figures/shared/control.ts'
import { namesIn } from '../lab/lesson.ts'
import { Shadow, themeProblem } from './shadow.ts'
import { inUnits } from './styles.ts'

type Given = Readonly<Record<string, unknown>> | string | null

/**
 * A figure of the tutorial: a picture, its controls and what comes of them. It comes alive when it is near the window.
 *
 * A name that there is not, and values that its controls can't have, are told of in it and by the event `error`.
 *
 * @tag slide-figure
 * @attr {string} name - Which figure.
 * @attr {JSON} values - Of its controls, by name; those that are not there are as the figure has them at first.
 * @attr {boolean} locked - For a lesson: nothing can be used but playing and the time.
 * @attr {string} controls - For a lesson: the controls that can be used, and no others, as `angle mu`.
 * @attr {string} hide - For a lesson: what readers are to find out, `readings`, `outcome` or both.
 * @attr {string} theme - `light` or `dark`, in the place of the page's own `color-scheme`.
 * @prop {string | null} name
 * @prop {Values} values - Of all its controls; setting it changes those that are given. Empty until it is alive.
 * @prop {boolean} locked
 * @prop {string | null} controls
 * @prop {string | null} hide
 * @prop {string | null} theme
 * @prop {'gravity' | 'normal' | 'friction' | 'sum' | 'velocity' | undefined} lit - The arrow to set off from the others.
 * @readonly {readonly Trajectory[]} trajectories - The runs, as `simulate` returned them.
 * @readonly {number} duration - Of the runs; 0 where the figure has no time [s].
 * @readonly {Playback} playback - Its cursor on time: `time` [s], `speed`, `playing`, `play()`, `pause()`, `seek(time)`,
 * `toStart()`, `toEnd()`, `stepFrames(count)`.
 * @method {(values: object) => void} set - Changes what controls say, and has it come alive. Throws RangeError for a
 * control or a value that there is not.
 * @fires {CustomEvent<Values>} change - A control has changed, by the reader or by the page. It bubbles and is composed.
 * @fires {CustomEvent<{ time: number }>} timeupdate - The instant shown has moved [s]; while it plays, as long as it can be
 * seen.
 * @fires {CustomEvent<{ message: string }>} error - There is no such figure, control, value, part or theme.
 * @slot - Shown until the figure is alive, and where there are no scripts.
 * @slot caption - Shown below.
 * @csspart pictures - All pictures, side by side or one under the other.
 * @csspart controls - Sliders, choices and switches.
 * @csspart transport - Playing, and the time slider.
 * @csspart readings - Numbers that come of it.
 * @csspart outcome - What comes of it, in a sentence.
 * @csspart message - There is no such figure, control, value or theme.
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
export class SlideFigureElement extends SlideFigure {
  static override properties = {
    ...SlideFigure.properties,
    values: { noAccessor: true, hasChanged: () => true },
    locked: { type: Boolean },
    controls: {},
    hide: {},
    theme: { reflect: true },
    problems: { state: true },
  }

  declare locked: boolean
  declare controls: string | null
  declare hide: string | null
  declare theme: string | null
  /** What is told of now, by the attribute that it is in. */
  declare private problems: Readonly<Record<string, string>>
  readonly #shadow = new Shadow(this)
  #given: Given = null
  /** Of these, what the figure has been asked for. */
  #taken: Given = null

  constructor() {
    super()
    this.problems = {}
    this.locked = false
    this.#shadow.root.append(document.createElement('slot'))
    this.playback.subscribe(this, 'write', () => {
      const { time } = this.playback
      this.dispatchEvent(new CustomEvent('timeupdate', { detail: { time } }))
    })
  }

  override get values(): ControlValues {
    return super.values
  }

  override set values(given: Given) {
    // A page that renders itself anew hands over equal values as a new object: that asks for nothing.
    if (JSON.stringify(given) === JSON.stringify(this.#given)) return
    this.#given = given
    this.requestUpdate('values')
  }

  override createRenderRoot(): HTMLElement {
    return this.#shadow.root
  }

  override willUpdate(changed: PropertyValues): void {
    // What readers may take hold of in the pictures goes by this too.
    if (this.view && ['locked', 'controls', 'hide'].some((name) => changed.has(name)))
      this.view = { ...this.view, values: { ...this.view.values } }
  }

  override shouldUpdate(changed: PropertyValues): boolean {
    // A first name is one that it has not yet come alive without.
    const isRenamed = changed.get('name') !== undefined || this.problems.name
    if (changed.has('name') && isRenamed) this.wakeAnew()
    else if (changed.has('values') && this.view) this.#take()
    if (changed.has('theme') && this.view) this.#noteTheme()
    if (['controls', 'hide'].some((name) => changed.has(name)) && this.view) this.#noteLesson()
    return Object.keys(this.problems).length > 0 || super.shouldUpdate(changed)
  }

  override update(changed: PropertyValues): void {
    // What the page had put there for the time being.
    if (!this.hasUpdated) this.#shadow.root.replaceChildren()
    super.update(changed)
  }

  override render() {
    const { problems, view } = this
    return html`${Object.values(problems).map(
      (problem) => html`<p class="problem" part="message" role="alert">${problem}</p>`,
    )}${view ? super.render() : nothing}`
  }

  protected override async comeAlive(): Promise<void> {
    const { root } = this.#shadow
    this.#taken = null
    this.#note('values', '')
    // The page may have had it change before it put it anywhere.
    await this.updateComplete
    try {
      await super.comeAlive()
      this.#note('name', '')
      this.#noteLesson()
      root.style.cssText = inUnits(root.style.cssText)
      this.#take()
    } catch (error) {
      this.#note('name', (error as Error).message)
    }
    this.#noteTheme()
    root.toggleAttribute('live', true)
  }

  #take(): void {
    const given = this.#given
    if (!given || given === this.#taken) return
    this.#taken = given
    try {
      const read: unknown = typeof given === 'string' ? JSON.parse(given) : given
      if (Object(read) !== read) throw new TypeError('these are no values by name')
      const wanted = Object.entries(read as object) as [string, unknown][]
      const { values } = this
      if (wanted.some(([name, value]) => JSON.stringify(value) !== JSON.stringify(values[name])))
        this.set(Object.fromEntries(wanted))
      this.#note('values', '')
    } catch (error) {
      this.#note('values', `values: ${(error as Error).message}`)
    }
  }

  protected override may = (control: string): boolean => {
    const { locked, controls = null } = this
    return (
      !locked && (controls === null || namesIn('controls', controls, [control]).names.length > 0)
    )
  }

  protected override hides = (part: 'readings' | 'outcome'): boolean =>
    namesIn('hide', this.hide, [part]).names.length > 0

  /** Tells of names in `controls` and `hide` that the figure has not. */
  #noteLesson(): void {
    const known = { controls: this.controlNames, hide: ['readings', 'outcome'] }
    for (const path of ['controls', 'hide'] as const) {
      const { problems } = namesIn(path, this[path], known[path])
      this.#note(path, problems.map(({ message }) => `${path}: ${message}`).join(' '))
    }
  }

  #noteTheme(): void {
    const problem = themeProblem(this.theme)
    this.#note('theme', problem && `theme: ${problem}`)
  }

  /** Tells of what is wrong with an attribute, or with '' that nothing is. */
  #note(attribute: string, message: string): void {
    const { [attribute]: before = '', ...others } = this.problems
    if (message === before) return
    this.problems = message ? { ...others, [attribute]: message } : others
    if (message) this.dispatchEvent(new CustomEvent('error', { detail: { message } }))
  }
}
