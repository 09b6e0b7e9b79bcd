import { html, LitElement, nothing } from 'lit'
import { freshId } from '../../ui/input.ts'
import type { LabView } from '../../lab/labView.ts'
import { isPublic, site } from '../../lab/site.ts'
import { linkTo } from '../../lab/state/address.ts'
import { toCsv, elementCode, fileName, frameCode, toJson } from './texts.ts'

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
  private readonly panelId = freshId('share')

  constructor() {
    super()
    this.close()
    this.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.open) return
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

  override disconnectedCallback(): void {
    super.disconnectedCallback()
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
        ${this.item('Copy link', () => this.copy(linkTo('', site(), this.state)))}
        ${this.item('Copy embed code: frame', () => this.embed(frameCode))}
        ${this.item('Copy embed code: element', () => this.embed(elementCode))}
        ${this.item('Copy as JSON', () => this.copy(toJson(this.state)))}
        ${this.item('Save picture (PNG)', this.savePicture)}
        ${this.item('Save data (CSV)', this.saveData)}
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

  private embed(code: typeof frameCode): void {
    if (isPublic()) return void this.copy(code(site(), this.state))
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
      this.saved(await pictureOf(canvas!), 'png')
    } catch (error) {
      this.status = (error as Error).message
    }
  }

  private readonly saveData = (): void => {
    const { runners, exact } = this.lab.simulated
    this.saved(new Blob([toCsv(runners, exact)], { type: 'text/csv;charset=utf-8' }), 'csv')
  }

  private saved(content: Blob, ending: string): void {
    const name = fileName(this.state, ending)
    save(content, name)
    this.byHand = ''
    this.status = `Saved as ${name}`
  }
}

/** Hands a file to the reader, as a download. */
function save(content: Blob, name: string): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(content)
  link.download = name
  link.click()
  // Some browsers take the content a little later.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}

/** What is drawn on a canvas, pixel by pixel. */
function pictureOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob)
      else reject(new Error('The browser could not make a picture of it.'))
    }, 'image/png')
  })
}

customElements.define('slide-share-menu', ShareMenu)
