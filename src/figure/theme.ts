const dark = matchMedia('(prefers-color-scheme: dark)')

/** Calls back whenever the page's colours may have changed: for what reads them once, such as a canvas. Returns its undoing. */
export function onThemeChange(callback: () => void): () => void {
  const observer = new MutationObserver(callback)
  observer.observe(document.documentElement, { attributeFilter: ['data-theme'] })
  dark.addEventListener('change', callback)
  return () => {
    observer.disconnect()
    dark.removeEventListener('change', callback)
  }
}
