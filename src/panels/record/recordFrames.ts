import { html, LitElement, nothing } from 'lit'
import { fixed, plain } from '../../chart/numbers.ts'
import type { LabView } from '../../lab/labView.ts'
import { MOST_RUNNERS } from '../../lab/state/check.ts'
import { durationsOf, summarize, summaryText } from '../../lab/state/frameTimes.ts'
import { binsOf, histogram } from './histogram.ts'
import { animationFrames, record } from './recording.ts'
import type { FrameSource } from './recording.ts'

/** How often the progress is shown [s]: the recorder must not be what slows the frames down. */
const PROGRESS = 0.1

/**
 * Takes down the frame times of the reader's own browser and makes them the clock of a runner.
 *
 * - `lab`: what the runners belong to
 * - `selected`: the name of the selected one
 * - `source`: where frames come from, this browser window unless told otherwise
 * - `length`: how long it records [s]
 */
class RecordFrames extends LitElement {
  static override properties = {
    lab: { attribute: false },
    selected: { attribute: false },
    recorded: { state: true },
    durations: { state: true },
    message: { state: true },
  }

  declare lab: LabView
  declare selected: string
  source: FrameSource = animationFrames
  length = 5
  /** How much is recorded, from 0 to 1; undefined while it does not record. */
  declare private recorded: number | undefined
  declare private durations: readonly number[]
  declare private message: string
  private cancel = () => {}
  private hadFocus = false

  constructor() {
    super()
    this.durations = []
    this.message = ''
  }

  override createRenderRoot(): this {
    return this
  }

  override willUpdate(): void {
    this.hadFocus = this.matches(':focus-within')
  }

  override updated(): void {
    // The button that was pressed may be gone or off, and must not take the focus with it.
    if (this.hadFocus && !this.querySelector(':focus:enabled'))
      this.querySelector('button')!.focus()
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stop('')
  }

  override render() {
    const { recorded, durations } = this
    return html`
      ${
        recorded === undefined
          ? html`<button type="button" class="add" @click=${this.start}>
              ${durations.length > 0 ? 'Record again' : 'Record my frames'}
            </button>`
          : this.progress(recorded)
      }
      <p class="said" role="status">${this.message}</p>
      ${durations.length > 0 ? this.sample(durations) : nothing}
    `
  }

  private readonly start = (): void => {
    this.stop('')
    this.durations = []
    this.recorded = 0
    const { source, length } = this
    const cancel = record({
      source,
      length,
      progress: (part) => {
        if ((part - this.recorded!) * length >= PROGRESS) this.recorded = part
      },
      done: (timestamps) => {
        this.stop('')
        this.durations = durationsOf(timestamps)
      },
    })
    document.addEventListener('visibilitychange', this.whenHidden)
    this.cancel = () => {
      cancel()
      document.removeEventListener('visibilitychange', this.whenHidden)
    }
  }

  private stop(message: string): void {
    this.cancel()
    this.cancel = () => {}
    this.recorded = undefined
    this.message = message
  }

  private readonly whenHidden = (): void => {
    if (document.hidden)
      this.stop('Stopped: the page was hidden, and a hidden page gets no frames.')
  }

  private progress(part: number) {
    return html`<div class="recording">
      <label
        >Recording ${fixed(part * this.length, 1)} of ${plain(this.length)} s; keep this page in
        sight <progress value=${part}></progress
      ></label>
      <button type="button" class="add" @click=${() => this.stop('')}>Cancel</button>
    </div>`
  }

  private sample(durations: readonly number[]) {
    const about = summaryText(durations)
    return html`<div class="sample">
      <p>${about}</p>
      ${histogram(binsOf(durations, summarize(durations).median), `Histogram of frame times: ${about}`)}
      <p class="small">
        Browsers round the times they tell, some to 0.1 ms and some to 1 ms; here they are rounded
        to 0.1 ms.
      </p>
      <button type="button" class="add" @click=${this.use}>Use for ${this.selected}</button>
      <button
        type="button"
        class="add"
        ?disabled=${this.lab.simulated.runners.length >= MOST_RUNNERS}
        @click=${this.add}
      >
        Use for a new runner
      </button>
    </div>`
  }

  private readonly use = (): void => {
    const { lab, frames } = this
    this.message =
      lab.change({ kind: 'runner', index: lab.selected, values: { frames } }) ||
      `${this.selected} now has your frames.`
  }

  private readonly add = (): void => {
    const { lab, frames } = this
    this.message = lab.change({ kind: 'add', frames }) || 'A new runner has your frames.'
    lab.select(lab.simulated.runners.length - 1)
  }

  private get frames() {
    return { kind: 'recorded', durations: [...this.durations] } as const
  }
}

customElements.define('slide-record-frames', RecordFrames)
