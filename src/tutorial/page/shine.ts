import type { LiveFigure } from './figures.ts'

/** What has a colour of its own in text, equations, listings and pictures. */
const ARROWS = ['gravity', 'normal', 'friction', 'sum', 'velocity']
const COLOURED = ARROWS.map((name) => `.${name}`).join()

/** Pointing at a coloured word, or at a line of code with one in it, lights its arrow in the figures of the section. */
export function shine(text: HTMLElement): void {
  text.addEventListener('pointerover', ({ target }) => {
    const at = target as Element
    const word = at.closest(COLOURED) ?? at.closest('.line')?.querySelector(COLOURED)
    const lit = ARROWS.find((name) => word?.classList.contains(name))
    light(at.closest('section'), lit)
  })
  text.addEventListener('pointerleave', () => light(text, undefined))
}

function light(part: Element | null, lit: string | undefined): void {
  for (const figure of part?.querySelectorAll<LiveFigure>('slide-figure[live]') ?? [])
    figure.lit = lit
}
