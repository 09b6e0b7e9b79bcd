/**
 * The keys that a control uses by itself, as the browser defines them. The project's own scripts prevent the default of
 * the keys that they use.
 */
const uses: readonly (readonly [controls: string, keys: RegExp])[] = [
  ['select', /^(.|Enter|Arrow\w+|Home|End|Page\w+)$/],
  ['input[type=range], .scroll', /^(Arrow\w+|Home|End|Page\w+)$/],
  ['input[type=radio]', /^( |Arrow\w+)$/],
  ['input[type=checkbox]', /^ $/],
  ['button, summary', /^( |Enter)$/],
  ['a', /^Enter$/],
  ['.scroll', /^ $/],
]

/** Where text is typed: any key may be a part of it, but those that are never. */
const fields = 'textarea, input:not([type=range], [type=radio], [type=checkbox])'
const neverTyped = /^(Tab|Escape|F\d+|Control|Shift|Alt|AltGraph|Meta|CapsLock|ContextMenu)$/

/** With Ctrl or ⌘: what changes a text or goes through it. */
const editing = /^([acvxyz]|Arrow\w+|Home|End|Backspace|Delete)$/i

/**
 * Keeps to an element the keys that a control in it uses, or that are typed in a field of it: the page around it, which
 * may turn a slide by an arrow, does not hear of them. It hears all others. To be called after everything in the element
 * that listens to keys, so that it hears what they did.
 */
export function keepKeys(host: HTMLElement): void {
  /** Kept when they were pressed, by their place on the keyboard. */
  const down = new Set<string>()
  host.addEventListener('keydown', (event) => {
    down.delete(event.code)
    if (!event.defaultPrevented && !isUsed(event)) return
    down.add(event.code)
    event.stopPropagation()
  })
  host.addEventListener('keypress', (event) => {
    if (down.has(event.code)) event.stopPropagation()
  })
  host.addEventListener('keyup', (event) => {
    if (down.delete(event.code)) event.stopPropagation()
  })
}

/** Whether what has the focus uses a key. */
function isUsed(event: KeyboardEvent): boolean {
  const { key, ctrlKey, metaKey, altKey } = event
  const target = event.composedPath()[0] as Element
  // Letters by AltGr, which Windows has as Ctrl with Alt.
  const isCommand = (ctrlKey || metaKey) && !event.getModifierState('AltGraph')
  if (target.matches(fields)) return isCommand ? editing.test(key) : !neverTyped.test(key)
  if (isCommand || altKey) return false
  return uses.some(([controls, keys]) => target.matches(controls) && keys.test(key))
}
