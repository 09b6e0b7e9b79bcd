/** Puts a button on a listing that copies it. */
export function copyButton(listing: HTMLElement): void {
  const code = listing.querySelector('code')!
  const button = document.createElement('button')
  button.type = 'button'
  button.className = 'copy'
  button.textContent = 'Copy'
  button.addEventListener('click', () => {
    const say = (word: string) => {
      button.textContent = word
      setTimeout(() => (button.textContent = 'Copy'), 2000)
    }
    navigator.clipboard.writeText(`${code.textContent}\n`).then(
      () => say('Copied'),
      () => {
        // A page that may not copy marks it, so that the reader can.
        getSelection()!.selectAllChildren(code)
        say('Selected')
      },
    )
  })
  button.setAttribute('aria-live', 'polite')
  listing.append(button)
}

/** What is too wide for its place can be reached by keyboard, to be scrolled there, by a name that no other has. */
export function reachable(boxes: readonly HTMLElement[]): void {
  const names = new Map(boxes.map((box, i) => [box, `${box.dataset.label}, ${i + 1}`]))
  const observer = new ResizeObserver((entries) => {
    for (const { target } of entries) {
      const box = target as HTMLElement
      const isTooWide = box.scrollWidth > box.clientWidth
      for (const [name, value] of [
        ['tabindex', '0'],
        ['role', 'region'],
        ['aria-label', names.get(box)!],
      ] as const)
        if (isTooWide) box.setAttribute(name, value)
        else box.removeAttribute(name)
    }
  })
  for (const box of boxes) observer.observe(box)
}
