/** As much of `<slide-figure>` as the text around it uses: see src/figures/element/slideFigure.ts. */
export interface LiveFigure extends HTMLElement {
  readonly values: Readonly<Record<string, unknown>>
  /** The arrow that is set off from the others. */
  lit: string | undefined
  set(values: Readonly<Record<string, unknown>>): void
}

/** The live figure of that name. The build has made sure that there is one. */
export function figureNamed(name: string): LiveFigure {
  return document.querySelector<LiveFigure>(`#figure-${name} slide-figure`)!
}

/** Brings what a link has changed before the reader's eyes, if it isn't. */
function bringIntoView(element: Element): void {
  const { top, bottom } = element.getBoundingClientRect()
  const isSeen = top < 0.6 * innerHeight && bottom > 0.4 * innerHeight
  const welcome = matchMedia('(prefers-reduced-motion: no-preference)').matches
  if (!isSeen) element.scrollIntoView({ block: 'center', behavior: welcome ? 'smooth' : 'instant' })
}

/** Links that do something: `set:` sets a figure, `lab:` opens an experiment in the lab. */
export function followLinks(text: HTMLElement): void {
  text.addEventListener('click', (event) => {
    const link = (event.target as Element).closest<HTMLAnchorElement>('a')
    // Into a new tab or window, a link is a link.
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return
    const { set, lab } = link.dataset
    if (set !== undefined) {
      event.preventDefault()
      const [name, query] = set.split('?')
      const figure = figureNamed(name!)
      figure.set(Object.fromEntries(new URLSearchParams(query)))
      bringIntoView(figure)
    } else if (lab !== undefined) {
      // The lab itself reads the address that the link leads to.
      const place = document.getElementById('lab')!
      place.scrollIntoView()
      place.focus({ preventScroll: true })
    }
  })
}

/** What has a colour of its own in text, equations, listings and pictures. */
const ARROWS = ['gravity', 'normal', 'friction', 'sum', 'velocity']
const COLOURED = ARROWS.map((name) => `.${name}`).join()

/**
 * Pointing at a coloured word, or at a line of code with one in it, highlights its arrow in the figures of the section.
 */
export function highlight(text: HTMLElement): void {
  text.addEventListener('pointerover', ({ target }) => {
    const at = target as Element
    const word = at.closest(COLOURED) ?? at.closest('.line')?.querySelector(COLOURED)
    const lit = ARROWS.find((name) => word?.classList.contains(name))
    highlightIn(at.closest('section'), lit)
  })
  text.addEventListener('pointerleave', () => highlightIn(text, undefined))
}

function highlightIn(part: Element | null, lit: string | undefined): void {
  for (const figure of part?.querySelectorAll<LiveFigure>('slide-figure[live]') ?? [])
    figure.lit = lit
}
