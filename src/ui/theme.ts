const followers = new Set<() => void>()

/**
 * Calls back when the page's colours may have changed, for canvases and others that read them once. Returns a function
 * that unsubscribes.
 */
export function onThemeChange(callback: () => void): () => void {
  const observer = new MutationObserver(callback)
  observer.observe(document.documentElement, { attributeFilter: ['data-theme'] })
  const system = ['(prefers-color-scheme: dark)', '(forced-colors: active)'].map((query) =>
    matchMedia(query),
  )
  for (const query of system) query.addEventListener('change', callback)
  followers.add(callback)
  return () => {
    observer.disconnect()
    for (const query of system) query.removeEventListener('change', callback)
    followers.delete(callback)
  }
}

/** Notifies of colours that changed by other means than the page's attribute or the system's setting. */
export function themeChanged(): void {
  for (const callback of followers) callback()
}

/** Like `onThemeChange`, and also calls back when a font has loaded, for what draws text. */
export function onRestyle(callback: () => void): () => void {
  const stopThemes = onThemeChange(callback)
  document.fonts.addEventListener('loadingdone', callback)
  return () => {
    stopThemes()
    document.fonts.removeEventListener('loadingdone', callback)
  }
}
