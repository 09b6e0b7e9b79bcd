/**
 * Notes what is pressed in a lab before the code that answers is there: a part that has only its button yet, or an empty
 * menu. `repeat` presses it again.
 */
export class EarlyPress {
  private pressed: HTMLElement | undefined

  constructor(lab: HTMLElement) {
    for (const type of ['click', 'mousedown']) lab.addEventListener(type, this.note, true)
  }

  private readonly note = (event: Event): void => {
    const target = event.composedPath()[0] as Element
    const part = target.closest<HTMLElement>('slide-share-menu:not(:defined), select[data-empty]')
    if (!part) return
    this.pressed = part
    // A menu without entries is not opened.
    if (part instanceof HTMLSelectElement) event.preventDefault()
  }

  repeat(): void {
    const { pressed } = this
    this.pressed = undefined
    if (pressed instanceof HTMLSelectElement) {
      pressed.focus()
      try {
        pressed.showPicker()
      } catch {
        // Not in every browser, and not long after the press: then it has the focus, and opens at the next.
      }
    } else pressed?.querySelector('button')?.click()
  }
}
