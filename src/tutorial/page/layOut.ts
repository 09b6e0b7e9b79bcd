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
    holdInPlace(target)
    return
  }
  const [first, ...others] = sections
  if (!first) return
  whenIdle(() => {
    first.classList.add(LAID_OUT)
    layOutInTurn(others)
  })
}

/** What a reader does who takes the page into their own hands. */
const TAKES_OVER = ['wheel', 'touchstart', 'pointerdown', 'keydown'] as const

/**
 * Keeps an element where it stands in the window, whatever grows above it, until the reader does something: the lab gets
 * its panels later, and Safari does not anchor the page's scrolling.
 */
function holdInPlace(element: Element): void {
  const { style } = document.documentElement
  const { top } = element.getBoundingClientRect()
  // Sizes are observed before anything is painted, so that nothing is seen to move.
  const observer = new ResizeObserver(() =>
    scrollBy({ top: element.getBoundingClientRect().top - top, behavior: 'instant' }),
  )
  const letGo = () => {
    observer.disconnect()
    style.overflowAnchor = ''
    for (const type of TAKES_OVER) removeEventListener(type, letGo)
  }
  // Two that hold it would each move the page.
  style.overflowAnchor = 'none'
  observer.observe(document.body)
  for (const type of TAKES_OVER) addEventListener(type, letGo, { passive: true })
}
