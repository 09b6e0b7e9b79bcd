import { html, LitElement } from 'lit'
import { fixed } from '../../chart/numbers.ts'
import { durationsOf } from '../../lab/state/frameTimes.ts'
import { animationFrames, record } from '../../panels/record/recording.ts'
import type { FrameSource } from '../../panels/record/recording.ts'

/**
 * A button that takes down the frame times of the reader's own browser.
 *
 * - `pick`: called with them [s]
 * - `source`: where frames come from, this browser window unless told otherwise
 * - `length`: how long it records [s]
 */
class FramesRecorder extends LitElement {
  static override properties = { recorded: { state: true }, message: { state: true } }

  declare pick: (durations: readonly number[]) => void
  source: FrameSource = animationFrames
  length = 5
  /** How much is recorded, from 0 to 1; undefined while it does not record. */
  declare private recorded: number | undefined
  declare private message: string
  private cancel = () => {}

  constructor() {
    super()
    this.message = ''
  }

  override createRenderRoot(): this {
    return this
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stop('')
  }

  override render() {
    const { recorded, length, message } = this
    const records = recorded !== undefined
    return html`<button type="button" @click=${records ? () => this.stop('') : this.start}>
        ${records ? 'Cancel' : `Record my frames for ${fixed(length, 0)} s`}
      </button>
      ${
        records
          ? html`<progress aria-label="Recording" value=${recorded}></progress>`
          : html`<span role="status">${message}</span>`
      }`
  }

  private readonly start = (): void => {
    this.recorded = 0
    const { source, length } = this
    const cancel = record({
      source,
      length,
      progress: (part) => {
        // Ten times a second: the recorder must not be what slows the frames down.
        if ((part - this.recorded!) * length >= 0.1) this.recorded = part
      },
      done: (timestamps) => {
        this.stop('Recorded.')
        this.pick(durationsOf(timestamps))
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
}

customElements.define('slide-frames-recorder', FramesRecorder)
