import css from '../styles/elements.css?inline'

/** What the page says of its own text ends at the root; a caption is the page's. */
const host = `
:host { display: block }
:host([hidden]) { display: none }
slide-lab-root, slide-figure-root { all: initial; display: block; color-scheme: inherit; color: var(--ink) }
slot { display: block; color-scheme: normal }
`

let sheet: CSSStyleSheet | undefined

/**
 * Gives an element a shadow root with all styles, so that the page around it and it leave each other alone, and in it a
 * root to render into. It has the element's name with `-root` in the styles' selectors, and takes the focus in its
 * place: a shadow host that can have the focus itself, but not by Tab, would keep Tab from all that is in it.
 */
export function rootIn(element: HTMLElement): HTMLElement {
  const root = document.createElement(`${element.localName}-root`)
  root.tabIndex = -1
  const caption = document.createElement('slot')
  caption.name = 'caption'
  const shadow = element.attachShadow({ mode: 'open' })
  shadow.adoptedStyleSheets = [(sheet ??= styles())]
  shadow.append(root, caption)
  return root
}

function styles(): CSSStyleSheet {
  const made = new CSSStyleSheet()
  made.replaceSync(host + inShadow(css))
  return made
}

/** The page's styles with selectors that say the same inside a shadow root. */
function inShadow(text: string): string {
  return text
    .replace(/\bslide-(lab|figure)\b(?!-)(?!:not\(:defined)/g, 'slide-$1-root')
    .replace(/:root(:not\(\[[^\]]*\]\))?/g, (_, not?: string) => (not ? `:host(${not})` : ':host'))
    .replace(/(^|[},])\s*(\[data-theme=[^\]]*\])/g, '$1:host($2)')
}
