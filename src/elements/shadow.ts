import type { ReactiveController, ReactiveControllerHost } from 'lit'
import { onVisible } from '../ui/visibility.ts'
import { themeChanged } from '../ui/theme.ts'
import { keepKeys } from './keys.ts'
import { isOnDark, onSurroundings } from './surroundings.ts'
import { styles } from './styles.ts'

const printing = ['beforeprint', 'afterprint'] as const

/**
 * The shadow root of an element, which lets the page around it and it leave each other alone. In it is a root to render
 * into, with the element's name and `-root`; it takes the focus in the element's place: a shadow host that can have the
 * focus itself, but not by Tab, would keep Tab from all that is in it. Below it is the page's caption.
 *
 * The element is dark where the page is: where its `color-scheme` or the background behind the element is. Paper is
 * light.
 */
export class Shadow implements ReactiveController {
  readonly root: HTMLElement
  private readonly caption = document.createElement('slot')
  private readonly states: CustomStateSet
  private stopWatching: (() => void)[] = []

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
    host.attachShadow({ mode: 'open' }).append(edge, this.caption)
    host.addController(this)
    keepKeys(host)
  }

  hostConnected(): void {
    const { shadowRoot, ownerDocument } = this.host
    // One that has been moved into the page of a frame has left its styles behind.
    const view = ownerDocument.defaultView
    if (view) shadowRoot!.adoptedStyleSheets = [styles(view)]
    this.follow()
    for (const type of printing) addEventListener(type, this.follow)
    // What is not displayed, in a closed tab of the page, has no transitions: it looks again when it is shown.
    this.stopWatching = [
      onVisible(this.host, () => this.follow()),
      onSurroundings(this.host, () => this.follow()),
    ]
  }

  hostDisconnected(): void {
    for (const stop of this.stopWatching) stop()
    for (const type of printing) removeEventListener(type, this.follow)
  }

  private readonly follow = (event?: Event): void => {
    const { columnRuleColor } = getComputedStyle(this.caption)
    const theme = this.host.getAttribute('theme')
    const isAsked = theme === 'light' || theme === 'dark'
    const isDark =
      event?.type !== printing[0] &&
      (columnRuleColor === 'rgb(255, 255, 255)' || (!isAsked && isOnDark(this.host)))
    if (isDark === this.states.has('dark')) return
    if (isDark) this.states.add('dark')
    else this.states.delete('dark')
    themeChanged()
  }
}

/** What is wrong with a `theme`, in words; '' where it is one, or there is none. */
export function themeProblem(theme: string | null | undefined): string {
  if (!theme || theme === 'light' || theme === 'dark') return ''
  return `“${theme}” is neither light nor dark, so the page’s own is taken`
}
