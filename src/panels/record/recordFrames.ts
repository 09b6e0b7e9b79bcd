import { html, nothing } from 'lit'
import { fixed, plain } from '../../chart/numbers.ts'
import type { LabView } from '../../lab/labView.ts'
import { summarize, summaryText } from '../../lab/state/frameTimes.ts'
import { binsOf, histogram } from './histogram.ts'
import { Recorder } from './recorder.ts'
import { useFrames } from './useFrames.ts'

/**
 * Takes down the frame times of the reader's own browser and makes them the clock of a runner.
 *
 * - `lab`: what the runners belong to
 * - `selected`: the name of the selected one
 */
class RecordFrames extends Recorder {
  static override properties = {
    ...Recorder.properties,
    lab: { attribute: false },
    selected: { attribute: false },
    durations: { state: true },
  }

  declare lab: LabView
  declare selected: string
  declare private durations: readonly number[]
  /** What a clock that tells time too coarsely leaves open. */
  private coarse = ''
  private hadFocus = false

  constructor() {
    super()
    this.durations = []
  }

  override willUpdate(): void {
    this.hadFocus = this.matches(':focus-within')
  }

  override updated(): void {
    // The button that was pressed may be gone or off, and must not take the focus with it.
    if (this.hadFocus && !this.querySelector(':focus:enabled'))
      this.querySelector('button')!.focus()
  }

  override render() {
    const { recorded, durations } = this
    return html`
      ${
        recorded === undefined
          ? html`<button type="button" class="add" @click=${() => this.start()}>
              ${durations.length > 0 ? 'Record again' : 'Record my frames'}
            </button>`
          : this.progress(recorded)
      }
      <p class="said" role="status">${this.message}</p>
      ${durations.length > 0 ? this.sample(durations) : nothing}
    `
  }

  protected override start(): void {
    this.durations = []
    super.start()
  }

  protected override take(durations: readonly number[], coarse: string): void {
    this.durations = durations
    this.coarse = coarse
  }

  private progress(part: number) {
    return html`<div class="recording">
      <label
        >Recording ${fixed(part * this.length, 1)} of ${plain(this.length)} s; keep this page in
        sight <progress value=${part}></progress
      ></label>
      <button type="button" class="add" @click=${() => this.stop()}>Cancel</button>
    </div>`
  }

  private sample(durations: readonly number[]) {
    const about = summaryText(durations)
    return html`<div class="sample">
      <p>${about}</p>
      ${histogram(binsOf(durations, summarize(durations).median), `Histogram of frame times: ${about}`)}
      ${this.coarse ? html`<p><b>${this.coarse}</b></p>` : nothing}
      <p class="small">
        Browsers round the times they tell, some to 0.1 ms and some to 1 ms; here they are rounded
        to 0.1 ms.
      </p>
      ${useFrames({
        ...{ lab: this.lab, selected: this.selected, whose: 'your frames' },
        durations: () => [...durations],
        tell: (message) => (this.message = message),
      })}
    </div>`
  }
}

customElements.define('slide-record-frames', RecordFrames)
