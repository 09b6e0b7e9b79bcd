/** The class of a section that is laid out for good: `reading.css` leaves the others until they come near. */
const LAID_OUT = 'laid-out'

/** Safari has no word for it. */
const whenIdle = window.requestIdleCallback ?? ((then: () => void) => setTimeout(then, 50))

/**
 * Lays sections out one at a time, whenever the browser has nothing else to do: the text is as long as twenty screens,
 * and a reader's first drag is not to wait for it. Where the address asks for a place in the text, all at once, since
 * what stands above it has to have its height.
 */
export function layOutInTurn(sections: readonly HTMLElement[]): void {
  const target = document.querySelector('.text :target')
  if (target) {
    for (const section of sections) section.classList.add(LAID_OUT)
    target.scrollIntoView()
    return
  }
  const [first, ...others] = sections
  if (!first) return
  whenIdle(() => {
    first.classList.add(LAID_OUT)
    layOutInTurn(others)
  })
}

/** Paper is light, whatever the page was switched to. */
export function lightOnPaper(): void {
  const { dataset } = document.documentElement
  let theme: string | undefined
  addEventListener('beforeprint', () => {
    theme = dataset.theme
    dataset.theme = 'light'
  })
  addEventListener('afterprint', () => {
    if (theme === undefined) delete dataset.theme
    else dataset.theme = theme
  })
}
