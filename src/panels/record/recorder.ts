import { LitElement } from 'lit'
import { coarseClock, durationsOf } from '../../lab/state/frameTimes.ts'
import { animationFrames, record } from './recording.ts'
import type { FrameSource } from './recording.ts'

/** How often the progress is shown [s]: the recorder must not be what slows the frames down. */
const PROGRESS = 0.1

/**
 * An element that takes down the frame times of the reader's own browser.
 *
 * - `source`: where frames come from, this browser window unless told otherwise
 * - `length`: how long it records [s]
 */
export abstract class Recorder extends LitElement {
  static override properties = { recorded: { state: true }, message: { state: true } }

  source: FrameSource = animationFrames
  length = 5
  /** How much is recorded, from 0 to 1; undefined while it does not record. */
  declare protected recorded: number | undefined
  declare protected message: string
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
    this.stop()
  }

  /** Called with the frame times that were recorded [s], and with what a coarse clock leaves open, if it is one. */
  protected abstract take(durations: readonly number[], coarse: string): void

  protected start(): void {
    this.stop()
    this.recorded = 0
    const { source, length } = this
    const cancel = record({
      source,
      length,
      progress: (part) => {
        if ((part - this.recorded!) * length >= PROGRESS) this.recorded = part
      },
      done: (timestamps) => {
        this.stop()
        this.take(durationsOf(timestamps), coarseClock(timestamps))
      },
    })
    document.addEventListener('visibilitychange', this.whenHidden)
    this.cancel = () => {
      cancel()
      document.removeEventListener('visibilitychange', this.whenHidden)
    }
  }

  protected stop(message = ''): void {
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
