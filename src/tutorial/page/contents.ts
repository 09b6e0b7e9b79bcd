/** Marks in the table of contents where the reader is, and closes it on screens where it would stand in the way. */
export function followReader(contents: HTMLElement): void {
  const links = [...contents.querySelectorAll<HTMLAnchorElement>('a')]
  const sections = links.map((link) => document.getElementById(link.hash.slice(1))!)
  const seen = new Set<Element>()
  const observer = new IntersectionObserver(
    (entries) => {
      for (const { target, isIntersecting } of entries)
        if (isIntersecting) seen.add(target)
        else seen.delete(target)
      // Where one section ends and the next begins, the reader is in the next.
      const current = sections.reduce((last, section, i) => (seen.has(section) ? i : last), -1)
      links.forEach((link, i) => {
        if (i === current) link.setAttribute('aria-current', 'location')
        else link.removeAttribute('aria-current')
      })
    },
    // A line a third down the window.
    { rootMargin: '-33% 0px -67% 0px' },
  )
  for (const section of sections) observer.observe(section)

  const details = contents.querySelector('details')!
  const wide = matchMedia('(width >= 75rem)')
  const fit = () => (details.open = wide.matches)
  wide.addEventListener('change', fit)
  fit()
  // Who has chosen a section from the list has done with it.
  contents.addEventListener('click', ({ target }) => {
    if ((target as Element).closest('a')) fit()
  })
}
