/**
 * Opens the fold that hides what the address asks for, now and whenever the address changes, since not every browser does so by
 * itself; and all folds for the time of printing.
 */
export function openWhatIsSought(text: HTMLElement): void {
  const open = () => {
    const sought = document.getElementById(location.hash.slice(1))
    const fold = sought && text.contains(sought) ? sought.closest('details') : null
    if (!fold || fold.open) return
    fold.open = true
    sought!.scrollIntoView()
  }
  addEventListener('hashchange', open)
  open()
  let closed: HTMLDetailsElement[] = []
  addEventListener('beforeprint', () => {
    closed = [...text.querySelectorAll<HTMLDetailsElement>('details:not([open])')]
    for (const fold of closed) fold.open = true
  })
  addEventListener('afterprint', () => {
    for (const fold of closed) fold.open = false
  })
}
