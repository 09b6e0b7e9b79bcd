import { bringIntoView, figureNamed } from './figures.ts'

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
