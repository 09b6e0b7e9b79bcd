/** Notes a link of the text that sets a figure and was pressed before the figures were there, for `follow` to press it again. */
export class EarlyLinks {
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
