import type { ReactiveController, ReactiveControllerHost } from 'lit'

interface Drop {
  /** What can be dropped on, and pasted into. */
  readonly sheet: () => HTMLElement | null
  readonly file: (file: File) => unknown
  readonly text: (text: string) => unknown
}

const fields = 'input, textarea, select'

/** Takes files and text that are dropped on a lab, or pasted while no field of it has the focus. */
export class DropTarget implements ReactiveController {
  private sheet: HTMLElement | null = null
  private readonly drop: Drop

  constructor(host: ReactiveControllerHost, drop: Drop) {
    this.drop = drop
    host.addController(this)
  }

  hostConnected(): void {
    this.sheet = this.drop.sheet()
    this.sheet?.addEventListener('dragover', this.over)
    this.sheet?.addEventListener('dragleave', this.left)
    this.sheet?.addEventListener('drop', this.dropped)
    this.sheet?.addEventListener('paste', this.pasted)
  }

  hostDisconnected(): void {
    this.sheet?.removeEventListener('dragover', this.over)
    this.sheet?.removeEventListener('dragleave', this.left)
    this.sheet?.removeEventListener('drop', this.dropped)
    this.sheet?.removeEventListener('paste', this.pasted)
  }

  private readonly over = (event: DragEvent): void => {
    if (!event.dataTransfer?.types.includes('Files')) return
    event.preventDefault()
    event.dataTransfer.dropEffect = 'copy'
    this.sheet!.toggleAttribute('data-dropping', true)
  }

  private readonly left = (event: DragEvent): void => {
    // Onto something inside it.
    if (this.sheet!.contains(event.relatedTarget as Node | null)) return
    this.sheet!.toggleAttribute('data-dropping', false)
  }

  private readonly dropped = (event: DragEvent): void => {
    const [file] = event.dataTransfer?.files ?? []
    this.sheet!.toggleAttribute('data-dropping', false)
    if (!file) return
    event.preventDefault()
    this.drop.file(file)
  }

  private readonly pasted = (event: ClipboardEvent): void => {
    if ((event.composedPath()[0] as Element).matches(fields)) return
    const [file] = event.clipboardData?.files ?? []
    const text = event.clipboardData?.getData('text/plain')
    if (!file && !text) return
    event.preventDefault()
    if (file) this.drop.file(file)
    else this.drop.text(text!)
  }
}
