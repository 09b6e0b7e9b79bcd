import { html } from 'lit'
import { fixed } from '../../chart/numbers.ts'
import { Recorder } from '../../panels/record/recorder.ts'

/**
 * A button that takes down the frame times of the reader's own browser.
 *
 * - `pick`: called with them [s]
 */
class FramesRecorder extends Recorder {
  declare pick: (durations: readonly number[]) => void

  override render() {
    const { recorded, length, message } = this
    const records = recorded !== undefined
    return html`<button type="button" @click=${() => (records ? this.stop() : this.start())}>
        ${records ? 'Cancel' : `Record my frames for ${fixed(length, 0)} s`}
      </button>
      ${
        records
          ? html`<progress aria-label="Recording" value=${recorded}></progress>`
          : html`<span role="status">${message}</span>`
      }`
  }

  protected override take(durations: readonly number[], coarse: string): void {
    this.message = coarse || 'Recorded.'
    this.pick(durations)
  }
}

customElements.define('slide-frames-recorder', FramesRecorder)
