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
export function bringIntoView(element: Element): void {
  const { top, bottom } = element.getBoundingClientRect()
  const isSeen = top < 0.6 * innerHeight && bottom > 0.4 * innerHeight
  const welcome = matchMedia('(prefers-reduced-motion: no-preference)').matches
  if (!isSeen) element.scrollIntoView({ block: 'center', behavior: welcome ? 'smooth' : 'instant' })
}
