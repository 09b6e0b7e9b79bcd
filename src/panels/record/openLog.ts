import { html, LitElement, nothing } from 'lit'
import { freshId } from '../../ui/input.ts'
import { ExperimentError } from '../../physics/index.ts'
import type { LabView } from '../../lab/labView.ts'
import { experimentsIn, labOf } from '../../lab/state/together.ts'
import type { Candidate } from '../../logs/index.ts'
import { DropTarget } from './dropTarget.ts'

/** Text that is longer than this is no log that anybody keeps, and browsers refuse some of it [bytes]. */
const MOST_BYTES = 256e6

/** A log that was read. */
interface Log {
  readonly name: string
  readonly candidates: readonly Candidate[]
}

/**
 * Takes the log of a tool that measures frame times: a file that is chosen or dropped on the lab, or text that is pasted. What
 * *Copy as JSON* has written comes back in the same ways. What reads a log is loaded with the first one.
 *
 * - `lab`: what the runners belong to
 * - `selected`: the name of the selected one
 */
class OpenLog extends LitElement {
  static override properties = {
    lab: { attribute: false },
    selected: { attribute: false },
    log: { state: true },
    reading: { state: true },
    pasting: { state: true },
    problem: { state: true },
    message: { state: true },
  }

  declare lab: LabView
  declare selected: string
  declare private log: Log | undefined
  /** How much is read, from 0 to 1; undefined while nothing is being read. */
  declare private reading: number | undefined
  declare private pasting: boolean
  declare private problem: string
  declare private message: string
  private readonly pasteId = freshId('paste')
  /** Counts what was asked to be read: only the newest is read to its end. */
  private asked = 0

  constructor() {
    super()
    this.pasting = false
    this.problem = ''
    this.message = ''
    new DropTarget(this, {
      sheet: () => this.closest('.sheet'),
      file: (file) => this.readFile(file),
      text: (text) => this.read(text, 'What was pasted'),
    })
  }

  override createRenderRoot(): this {
    return this
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stop()
  }

  override render() {
    const { log, reading, pasting, problem, message } = this
    return html`<button type="button" class="add" @click=${this.choose}>Open a log</button>
      <input
        type="file"
        hidden
        tabindex="-1"
        aria-label="A log of frame times"
        @change=${this.chosen}
      />
      <button
        type="button"
        class="add"
        aria-expanded=${pasting}
        aria-controls=${this.pasteId}
        @click=${this.togglePaste}
      >
        Paste a log
      </button>
      <p class="small">
        Or drop one on the lab: from PresentMon, OCAT, CapFrameX, MangoHud, FRAPS, Afterburner, a
        trace of Chrome, a list of frame times, or what <i>Copy as JSON</i> gave you. It stays in
        this browser: nothing is sent anywhere.
      </p>
      <div id=${this.pasteId} ?hidden=${!pasting}>${pasting ? this.pasteField() : nothing}</div>
      ${
        reading === undefined
          ? nothing
          : html`<div class="recording">
              <label>Reading <progress value=${reading}></progress></label>
              <button type="button" class="add" @click=${this.cancel}>Cancel</button>
            </div>`
      }
      ${problem ? html`<p class="problem" role="alert">${problem}</p>` : nothing}
      <p class="said" role="status">${message}</p>
      ${
        log
          ? html`<slide-log-sample
              .candidates=${log.candidates}
              .name=${log.name}
              .lab=${this.lab}
              .selected=${this.selected}
              .tell=${(message: string) => (this.message = message)}
              .close=${this.close}
            ></slide-log-sample>`
          : nothing
      }`
  }

  private pasteField() {
    const read = () => {
      const field = this.querySelector('textarea')!
      void this.read(field.value, 'What was pasted')
    }
    return html`<label class="paste"
        >A log, or a list of frame times
        <textarea rows="5" spellcheck="false" autocomplete="off"></textarea>
      </label>
      <button type="button" class="add" @click=${read}>Read it</button>`
  }

  private readonly choose = (): void =>
    this.querySelector<HTMLInputElement>('input[type="file"]')!.click()

  private readonly chosen = (event: Event): void => {
    const input = event.target as HTMLInputElement
    const [file] = input.files ?? []
    if (file) void this.readFile(file)
    // The same file may be chosen again, once it has been changed.
    input.value = ''
  }

  private readonly togglePaste = async (): Promise<void> => {
    this.pasting = !this.pasting
    await this.updateComplete
    this.querySelector('textarea')?.focus()
  }

  private readonly cancel = (): void => {
    this.stop()
    this.querySelector('button')!.focus()
  }

  private readonly close = (): void => {
    this.log = undefined
    this.message = ''
    this.querySelector('button')!.focus()
  }

  private stop(): void {
    this.asked++
    this.reading = undefined
  }

  private async readFile(file: File): Promise<void> {
    if (file.size > MOST_BYTES) {
      this.stop()
      this.problem = `${file.name} has more than ${MOST_BYTES / 1e6} MB.`
      return
    }
    try {
      const bytes = new Uint8Array(await file.arrayBuffer())
      // What Windows writes from its own shell begins with this mark.
      const encoding = bytes[0] === 0xff && bytes[1] === 0xfe ? 'utf-16le' : 'utf-8'
      await this.read(new TextDecoder(encoding).decode(bytes), file.name)
    } catch (error) {
      this.problem = `${file.name} could not be read: ${(error as Error).message}`
    }
  }

  private async read(text: string, name: string): Promise<void> {
    const asked = ++this.asked
    this.log = undefined
    this.problem = ''
    this.message = ''
    const experiments = experimentsIn(text)
    if (experiments) {
      this.reading = undefined
      return this.show(experiments)
    }
    this.reading = 0
    try {
      const { readInSlices } = await import('./logSample.ts')
      const candidates = await readInSlices(text, (part) => {
        const isNewest = asked === this.asked
        if (isNewest && part - this.reading! > 0.01) this.reading = part
        return isNewest
      })
      if (candidates) {
        this.log = { name, candidates }
        this.pasting = false
      }
    } catch (error) {
      if (asked === this.asked) this.problem = `${name}: ${(error as Error).message}`
    }
    if (asked !== this.asked) return
    this.reading = undefined
    await this.updateComplete
    const sample = this.querySelector<LitElement>('slide-log-sample')
    await sample?.updateComplete
    // What is read aloud next, and comes into view: the field that the focus was in is gone.
    sample?.querySelector('section')!.focus()
  }

  private show(experiments: readonly unknown[]): void {
    try {
      this.lab.change({ kind: 'state', state: labOf(experiments) })
      this.message = 'The lab shows these experiments.'
    } catch (error) {
      if (!(error instanceof ExperimentError)) throw error
      this.problem = error.message
    }
  }
}

customElements.define('slide-open-log', OpenLog)
