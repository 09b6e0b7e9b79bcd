import type { ReactiveController, ReactiveControllerHost } from 'lit'
import { onSight } from '../figure/sight.ts'
import { themeChanged } from '../figure/theme.ts'
import { styles } from './styles.ts'

/**
 * The shadow root of an element, which lets the page around it and it leave each other alone. In it is a root to render
 * into, with the element's name and `-root`; it takes the focus in the element's place: a shadow host that can have the
 * focus itself, but not by Tab, would keep Tab from all that is in it. Below it is the page's caption.
 *
 * The element is dark where the page is: as the browser draws its own buttons there, by the CSS property `color-scheme`.
 */
export class Shadow implements ReactiveController {
  readonly root: HTMLElement
  private readonly caption = document.createElement('slot')
  private readonly states: CustomStateSet
  private stopWatching = () => {}

  constructor(private readonly host: ReactiveControllerHost & HTMLElement) {
    this.states = host.attachInternals().states
    this.root = document.createElement(`${host.localName}-root`)
    this.root.tabIndex = -1
    const edge = document.createElement('div')
    edge.className = 'edge'
    // Whatever the page's language is.
    edge.lang = 'en'
    edge.append(this.root)
    this.caption.name = 'caption'
    // See styles.ts: a property that shows the colour scheme, and says so when it changes.
    this.caption.addEventListener('transitionrun', ({ target }) => {
      if (target === this.caption) this.follow()
    })
    const shadow = host.attachShadow({ mode: 'open' })
    shadow.adoptedStyleSheets = [styles()]
    shadow.append(edge, this.caption)
    host.addController(this)
  }

  hostConnected(): void {
    this.follow()
    // What is not displayed, in a closed tab of the page, has no transitions: it looks again when it is shown.
    this.stopWatching = onSight(this.host, () => this.follow())
  }

  hostDisconnected(): void {
    this.stopWatching()
  }

  private follow(): void {
    const isDark = getComputedStyle(this.caption).columnRuleColor === 'rgb(255, 255, 255)'
    if (isDark === this.states.has('dark')) return
    if (isDark) this.states.add('dark')
    else this.states.delete('dark')
    themeChanged()
  }
}
