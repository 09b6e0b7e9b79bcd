/** The class of a section that is laid out for good: `reading.css` leaves the others until they come near. */
const LAID_OUT = 'laid-out'

/** Of a frame that takes less time than this, enough is left over [ms]. */
const LEFT_OVER = 8
/** How long to wait before asking again [ms]. */
const AGAIN = 100

/**
 * Lays sections out one at a time while nothing on the page moves: the text is as long as twenty screens, and neither a
 * reader's first drag nor a run that plays is to wait for it. A section that comes near before is laid out by the browser.
 * Where the address asks for a place in the text, all are laid out at once, since what stands above it has to have its
 * height.
 */
export function layOutInTurn(sections: readonly HTMLElement[]): void {
  const waiting = [...sections]
  const land = () => {
    const target = document.querySelector('.text :target')
    if (!target) return
    removeEventListener('hashchange', land)
    for (const section of waiting.splice(0)) section.classList.add(LAID_OUT)
    target.scrollIntoView()
    holdInPlace(target)
  }
  const next = () => {
    if (waiting.length === 0) return removeEventListener('hashchange', land)
    whenAtRest(() => {
      const section = waiting.shift()
      if (section) layOut(section)
      next()
    })
  }
  addEventListener('hashchange', land)
  land()
  next()
}

/** Lays out a section; one above the window pushes nothing of what the reader sees. */
function layOut(section: HTMLElement): void {
  const { bottom } = section.getBoundingClientRect()
  section.classList.add(LAID_OUT)
  const moved = section.getBoundingClientRect().bottom - bottom
  // Safari's pages have no anchor.
  if (bottom <= 0 && !CSS.supports('overflow-anchor: auto'))
    scrollBy({ top: moved, behavior: 'instant' })
}

/**
 * Calls back in a frame that has time left over. `requestIdleCallback` calls between any two frames of a run that plays,
 * which the next one then waits for, and Safari has none.
 */
function whenAtRest(then: () => void): void {
  requestAnimationFrame((start) =>
    setTimeout(() => {
      if (performance.now() - start < LEFT_OVER) then()
      else setTimeout(() => whenAtRest(then), AGAIN)
    }),
  )
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
