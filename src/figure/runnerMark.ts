import { html, LitElement } from 'lit'
import { markPath } from '../view/marks.ts'
import { onThemeChange } from './theme.ts'

/**
 * A runner's mark in its colour, the one that its dots have in the picture.
 *
 * - `look`: its place in the palette and the list of marks
 * - `hollow`: only its outline, for a runner that is hidden
 */
export class RunnerMark extends LitElement {
  static override properties = { look: { type: Number }, hollow: { type: Boolean } }

  declare look: number
  declare hollow: boolean
  private stopWatching = () => {}

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    this.stopWatching = onThemeChange(() => this.draw())
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
  }

  override render() {
    return html`<canvas aria-hidden="true"></canvas>`
  }

  override updated(): void {
    this.draw()
  }

  private draw(): void {
    const canvas = this.querySelector('canvas')
    const pen = canvas?.getContext('2d')
    if (!canvas || !pen) return
    const size = Math.round(16 * devicePixelRatio)
    canvas.width = canvas.height = size
    const mark = markPath(this.look, size / 2, size / 2, 0.4 * size)
    const colour = getComputedStyle(this).getPropertyValue(`--runner-${this.look}`)
    pen.fillStyle = pen.strokeStyle = colour
    pen.lineWidth = 1.5 * devicePixelRatio
    pen.lineJoin = 'round'
    if (this.hollow) pen.stroke(mark)
    else pen.fill(mark)
  }
}
