import { html, LitElement } from 'lit'
import { icon } from './icons.ts'

const themes = ['system', 'light', 'dark'] as const

/** A button that cycles through the page's themes: the system's, light, dark. It stores nothing. */
class ThemeSwitch extends LitElement {
  static override properties = { theme: { state: true } }

  declare private theme: (typeof themes)[number]

  constructor() {
    super()
    this.theme = 'system'
  }

  override createRenderRoot(): this {
    return this
  }

  override render() {
    const label = `Theme: ${this.theme}`
    return html`<button type="button" title=${label} aria-label=${label} @click=${this.next}>
      ${icon('theme')}
    </button>`
  }

  private readonly next = (): void => {
    this.theme = themes[(themes.indexOf(this.theme) + 1) % themes.length]!
    const { dataset } = document.documentElement
    if (this.theme === 'system') delete dataset.theme
    else dataset.theme = this.theme
  }
}

customElements.define('slide-theme-switch', ThemeSwitch)
