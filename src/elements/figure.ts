import { figures } from '../figure/figures/index.ts'
import { SlideFigure } from '../figure/slideFigure.ts'
import { rootIn } from './shadow.ts'

/** `<slide-figure>` for other people's pages: see `src/elements.ts` for what it offers. */
export class SlideFigureElement extends SlideFigure {
  constructor() {
    super()
    this.playback.watch(this, 'write', () => {
      const { time } = this.playback
      this.dispatchEvent(new CustomEvent('timeupdate', { detail: { time } }))
    })
  }

  override createRenderRoot() {
    return rootIn(this)
  }

  protected override async comeAlive(): Promise<void> {
    if (!figures.some(({ id }) => id === this.name)) return this.refuse()
    const { cssText } = this.style
    await super.comeAlive()
    // What the page had said of its size goes on holding.
    this.style.cssText += cssText
    ;(this.renderRoot as HTMLElement).toggleAttribute('live', true)
  }

  private refuse(): void {
    const known = figures.map(({ id }) => id).join(', ')
    const message = `There is no figure “${this.name ?? ''}”. There are: ${known}.`
    const text = Object.assign(document.createElement('p'), { textContent: message, role: 'alert' })
    text.style.padding = '1rem'
    this.renderRoot.replaceChildren(text)
    // It needs no room for more.
    ;(this.renderRoot as HTMLElement).toggleAttribute('live', true)
    this.dispatchEvent(new CustomEvent('error', { detail: { message } }))
  }
}
