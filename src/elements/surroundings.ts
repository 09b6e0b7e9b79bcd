/** Whether an element stands on something dark, by the nearest background that it has behind it. */
export function isOnDark(element: Element): boolean {
  for (const each of ancestors(element)) {
    const { lightness, alpha } = colourOf(getComputedStyle(each).backgroundColor)
    if (alpha >= 0.5) return lightness < 0.5
  }
  return false
}

/**
 * Calls back when the page around an element may have changed its theme: an attribute of its own or of what it stands in, a style sheet,
 * a background that has got to its new colour, the system's setting. Returns a function that unsubscribes.
 */
export function onSurroundings(element: Element, callback: () => void): () => void {
  const { ownerDocument } = element
  const around = new MutationObserver(callback)
  for (const each of [element, ...ancestors(element)]) around.observe(each, { attributes: true })
  around.observe(ownerDocument.head, {
    attributes: true,
    childList: true,
    subtree: true,
  })
  const dark = matchMedia('(prefers-color-scheme: dark)')
  const loaded = ({ target }: Event) => {
    if ((target as Element).localName === 'link') callback()
  }
  const changed = ({ target, propertyName }: TransitionEvent) => {
    if (propertyName === 'background-color' && (target as Node).contains(element)) callback()
  }
  dark.addEventListener('change', callback)
  ownerDocument.addEventListener('load', loaded, true)
  ownerDocument.addEventListener('transitionend', changed)
  return () => {
    around.disconnect()
    dark.removeEventListener('change', callback)
    ownerDocument.removeEventListener('load', loaded, true)
    ownerDocument.removeEventListener('transitionend', changed)
  }
}

/** What an element stands in, from the inside out, through shadow roots. */
function* ancestors(element: Element): Generator<Element> {
  let at: Element | null = element
  while ((at = at.assignedSlot ?? at.parentElement ?? hostOf(at))) yield at
}

function hostOf(element: Element): Element | null {
  const root = element.getRootNode()
  return root instanceof ShadowRoot ? root.host : null
}

/** How light a computed colour is, 0 to 1, and how opaque. */
function colourOf(colour: string): { lightness: number; alpha: number } {
  const [a = 0, b = 0, c = 0, alpha = 1] = (colour.match(/-?[\d.]+(e-?\d+)?/g) ?? []).map(Number)
  if (/^ok/.test(colour)) return { lightness: a, alpha }
  if (/^l/.test(colour)) return { lightness: a / 100, alpha }
  const most = colour.startsWith('rgb') ? 255 : 1
  return { lightness: (0.2126 * a + 0.7152 * b + 0.0722 * c) / most, alpha }
}
