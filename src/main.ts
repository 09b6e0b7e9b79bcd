/**
 * Notes a link of the text that sets a figure and was pressed before the figures were there, for `follow` to press it
 * again.
 */
class EarlyLinks {
  private pressed: HTMLElement | undefined

  constructor() {
    addEventListener('click', this.note, true)
  }

  private readonly note = (event: MouseEvent): void => {
    const link = (event.target as Element).closest<HTMLElement>('a[data-set]')
    // Into a new tab or window, a link is a link.
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return
    event.preventDefault()
    this.pressed = link
  }

  follow(): void {
    removeEventListener('click', this.note, true)
    this.pressed?.click()
  }
}

const links = new EarlyLinks()

// Text and pictures are shown first, then they come alive: in a task of its own after the first frame.
requestAnimationFrame(() => setTimeout(comeAlive))

async function comeAlive(): Promise<void> {
  const { defineLab } = await import('./panels/slideLab.ts')
  defineLab()
  // The lab comes first: the figures are pictures until they are near, and the text needs no script.
  await import('./reading.ts')
  links.follow()
}
