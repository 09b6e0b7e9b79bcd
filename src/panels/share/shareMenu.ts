import { html, LitElement, nothing } from 'lit'
import { decimalSign } from '../../chart/typedNumber.ts'
import { freshId } from '../../ui/input.ts'
import type { LabView } from '../../lab/labView.ts'
import { isPublic, onSiteChange, site } from '../../lab/site.ts'
import { linkTo, whyNoLink } from '../../lab/state/address.ts'
import { lessonLink } from './lessonLink.ts'
import { toCsv, elementCode, fileName, frameCode, markdownCode, toJson } from './texts.ts'
import type { CsvStyle } from './texts.ts'
import { pictureOf } from './picture.ts'

/**
 * A button with a menu under it of ways to take elsewhere what a lab shows.
 *
 * - `lab`: the lab
 */
class ShareMenu extends LitElement {
  static override properties = {
    lab: { attribute: false },
    open: { state: true },
    status: { state: true },
    byHand: { state: true },
  }

  declare lab: LabView
  declare private open: boolean
  /** What has just been done. */
  declare private status: string
  /** What the reader has to copy, since the browser would not. */
  declare private byHand: string
  private stopAskingSite = () => {}
  private readonly panelId = freshId('share')

  constructor() {
    super()
    this.close()
    this.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.open) return
      event.preventDefault()
      this.close()
      this.querySelector('button')!.focus()
    })
    this.addEventListener('focusout', ({ relatedTarget }) => {
      if (relatedTarget && !this.contains(relatedTarget as Node)) this.close()
    })
  }

  override createRenderRoot(): this {
    // The button that stood for it.
    const hadFocus = this.matches(':focus-within')
    this.replaceChildren()
    if (hadFocus) void this.updateComplete.then(() => this.querySelector('button')!.focus())
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    this.stopAskingSite = onSiteChange(() => this.requestUpdate())
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopAskingSite()
    document.removeEventListener('pointerdown', this.elsewhere)
  }

  override render() {
    return html`<button
        type="button"
        class="toggle"
        aria-expanded=${this.open}
        aria-controls=${this.panelId}
        @click=${this.toggle}
      >
        Share
      </button>
      <div class="panel" id=${this.panelId} ?hidden=${!this.open}>
        ${this.open ? this.links() : nothing}
        ${this.item('Copy as JSON', () => this.copy(toJson(this.state)))}
        ${this.item('Save picture (PNG)', this.savePicture)}
        ${this.item('Save data (CSV)', () => this.saveData())}
        ${this.item(semicolons.label, () => this.saveData(semicolons))}
        ${
          this.byHand
            ? html`<textarea
                readonly
                rows="4"
                aria-label="Text to copy"
                .value=${this.byHand}
              ></textarea>`
            : nothing
        }
        <p role="status">${this.status}</p>
      </div>`
  }

  /** What leads to the lab’s own pages, where there are any. */
  private links() {
    const home = site()
    if (home === null) return nothing
    return html`${this.item('Copy link', () => this.copyLink(home))}
    ${this.item('Copy embed code: HTML', () => this.embed(elementCode, home))}
    ${this.item('Copy embed code: Markdown, MDX', () => this.embed(markdownCode, home))}
    ${this.item('Copy embed code: frame', () => this.embed(frameCode, home))}
    ${
      // A compact lab has too little to choose from.
      this.closest('.tools')
        ? lessonLink(this.lab, (lesson) => this.copyLink(home, lesson))
        : nothing
    }`
  }

  private item(label: string, act: () => unknown) {
    return html`<button type="button" @click=${act}>${label}</button>`
  }

  private get state() {
    return this.lab.simulated.state
  }

  private readonly toggle = (): void => {
    if (this.open) return this.close()
    this.open = true
    document.addEventListener('pointerdown', this.elsewhere)
  }

  private close(): void {
    this.open = false
    this.status = ''
    this.byHand = ''
    document.removeEventListener('pointerdown', this.elsewhere)
  }

  private readonly elsewhere = (event: Event): void => {
    if (!event.composedPath().includes(this)) this.close()
  }

  private copyLink(home: string, lesson = ''): void {
    if (!this.isTooLong()) void this.copy(linkTo('', home, this.state, lesson))
  }

  /** Says so where a link would be longer than what can be read again. */
  private isTooLong(): boolean {
    const problem = whyNoLink(this.state)
    if (problem) {
      this.byHand = ''
      this.status = `${problem} Copy it as JSON: dropped on a lab or pasted there, it brings all of this back.`
    }
    return problem !== ''
  }

  private embed(code: typeof frameCode, home: string): void {
    if (code === frameCode && this.isTooLong()) return
    if (isPublic()) return void this.copy(code(home, this.state))
    this.byHand = ''
    this.status = 'This page is a file on your computer. One on the web has code to embed it.'
  }

  private async copy(text: string): Promise<void> {
    this.byHand = ''
    try {
      await navigator.clipboard.writeText(text)
      this.status = 'Copied.'
    } catch {
      // The page is not on a safe connection, or the reader has not allowed it.
      this.byHand = text
      this.status = 'The browser did not let the page copy this. Copy it by hand.'
      await this.updateComplete
      this.querySelector('textarea')!.select()
    }
  }

  private readonly savePicture = async (): Promise<void> => {
    const canvas = this.closest('.sheet')!.querySelector<HTMLCanvasElement>('slide-stage canvas')
    try {
      const name = fileName(this.state, 'png')
      save(await pictureOf(canvas!), name)
      this.byHand = ''
      this.status = isFramed
        ? `Saved as ${name}, if this frame may save files.`
        : `Saved as ${name}`
    } catch (error) {
      this.status = (error as Error).message
    }
  }

  private saveData(style?: CsvStyle): void {
    const { runners, exact } = this.lab.simulated
    const name = fileName(this.state, 'csv')
    const text = toCsv(runners, exact, style)
    save(new Blob([text], { type: 'text/csv;charset=utf-8' }), name)
    this.byHand = isFramed ? text : ''
    this.status = isFramed
      ? `Saved as ${name}, if this frame may save files. Otherwise copy the text.`
      : `Saved as ${name}`
  }
}

/** What spreadsheets of the reader's language open: most of those with decimal commas take semicolons between cells. */
const semicolons = {
  separator: ';',
  decimal: decimalSign,
  label: `Save data (CSV, semicolons${decimalSign === ',' ? ', decimal commas' : ''})`,
} as const

/** A page in a frame can’t know whether it may save files: the sandbox refuses without a word to it. */
const isFramed = typeof window === 'object' && window.parent !== window

/** Hands a file to the reader, as a download. */
function save(content: Blob, name: string): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(content)
  link.download = name
  link.click()
  // Some browsers take the content a little later.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}

customElements.define('slide-share-menu', ShareMenu)
