import { html, LitElement } from 'lit'
import { measureScale, penOf } from '../../chart/pen.ts'
import { forgetWidths } from '../../chart/text.ts'
import { drawDisc } from '../../view/handles.ts'
import { PaletteReader } from '../../view/palette.ts'
import { pointIn, valueByKey } from '../../ui/input.ts'
import { onRestyle } from '../../ui/theme.ts'
import type { Playback } from '../../lab/playback/playback.ts'
import type { Controls, NumberControl, ControlValues } from '../shared/control.ts'
import type { Grip, Panel, View } from '../shared/figure.ts'
import { quantityText } from './controls.ts'

/**
 * One picture of a figure, and over each grip a target for mouse, finger and keyboard.
 *
 * - `panel`: what draws it
 * - `view`: what it shows at an instant; `values`: of the controls, a new object whenever it shows something else
 * - `highlighted`: the arrow of the view that is lit
 * - `controls`, `set`: what grips change; `may`: whether readers may
 * - `playback`: the instant
 * - `description`: what there is to see, in words
 */
class FigurePicture extends LitElement {
  static override properties = {
    panel: { attribute: false },
    values: { attribute: false },
    description: { attribute: false },
    highlighted: { attribute: false },
    held: { state: true },
    lit: { state: true },
  }

  declare panel: Panel
  declare values: ControlValues
  declare description: string
  /** Of the view: it is drawn anew when this changes. */
  declare highlighted: string | undefined
  declare controls: Controls
  declare playback: Playback
  declare view: (time: number) => View
  declare set: (values: Readonly<Record<string, unknown>>) => void
  declare may: (control: string) => boolean
  declare private held: string | undefined
  declare private lit: string | undefined
  private readonly canvas = document.createElement('canvas')
  private readonly context = this.canvas.getContext('2d')!
  private readonly colours = new PaletteReader(this.canvas)
  private offset = { x: 0, y: 0 }
  private size = { width: 0, height: 0 }
  private stopWatching = () => {}

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    const redraw = () => {
      measureScale(this.canvas)
      forgetWidths()
      this.requestUpdate()
    }
    const recolour = () => {
      redraw()
      // At once: before it prints, Firefox runs no microtask.
      if (this.hasUpdated) this.draw()
    }
    const sizes = new ResizeObserver(([entry]) => {
      const { width, height } = entry!.contentRect
      this.size = { width, height }
      redraw()
    })
    sizes.observe(this)
    addEventListener('resize', redraw)
    const stopStyles = onRestyle(recolour)
    const stopTime = this.playback.subscribe(this, 'draw', () => this.draw())
    this.stopWatching = () => {
      sizes.disconnect()
      removeEventListener('resize', redraw)
      stopStyles()
      stopTime()
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
  }

  override willUpdate(): void {
    const { wide, narrow } = this.panel.shape
    this.style.setProperty('--wide', String(1 / wide))
    this.style.setProperty('--narrow', String(1 / narrow))
    if (this.description) {
      this.canvas.role = 'img'
      this.canvas.ariaLabel = this.description
    } else this.canvas.ariaHidden = 'true'
    this.draw()
  }

  override render() {
    return html`${this.canvas}${this.grips().map((grip) => this.target(grip))}`
  }

  private grips(): readonly Grip[] {
    const { panel, size, playback } = this
    if (size.width === 0) return []
    const grips = panel.grips?.(size, this.view(playback.time)) ?? []
    return grips.filter(({ control }) => this.may(control))
  }

  private draw(): void {
    const { context, panel, size, playback, held, lit } = this
    const { width, height } = size
    if (width === 0) return
    penOf(this.canvas, width, height)
    const palette = this.colours.read()
    context.save()
    panel.draw({ context, width, height, palette }, this.view(playback.time))
    context.restore()
    for (const grip of this.grips())
      drawDisc(context, grip, grip.control === (held ?? lit), palette)
  }

  private target(grip: Grip) {
    const { control: name, x, y } = grip
    const control = this.controls[name] as NumberControl
    const value = this.values[name] as number
    return html`<div
      class="grip"
      role="slider"
      tabindex="0"
      data-control=${name}
      .style="left: ${x}px; top: ${y}px"
      aria-label="${control.label}, in the picture"
      aria-valuemin=${control.from}
      aria-valuemax=${control.to}
      aria-valuenow=${value}
      aria-valuetext=${quantityText(control, value)}
      @pointerenter=${() => (this.lit = name)}
      @pointerleave=${() => (this.lit = undefined)}
      @focus=${() => (this.lit = name)}
      @blur=${() => (this.lit = undefined)}
      @pointerdown=${(event: PointerEvent) => this.take(event, grip)}
      @pointermove=${(event: PointerEvent) => this.move(event, grip)}
      @lostpointercapture=${() => (this.held = undefined)}
      @keydown=${(event: KeyboardEvent) => {
        const next = valueByKey(event, control, value)
        if (next === undefined) return
        event.preventDefault()
        this.set({ [name]: next })
      }}
    ></div>`
  }

  private take(event: PointerEvent, { control, x, y }: Grip): void {
    if (event.button !== 0) return
    ;(event.currentTarget as HTMLElement).setPointerCapture(event.pointerId)
    const at = pointIn(this.canvas, event)
    this.offset = { x: x - at.x, y: y - at.y }
    this.held = control
  }

  private move(event: PointerEvent, grip: Grip): void {
    if (this.held !== grip.control) return
    const { x, y } = pointIn(this.canvas, event)
    this.set({ [grip.control]: grip.at({ x: x + this.offset.x, y: y + this.offset.y }) })
  }
}

customElements.define('slide-figure-picture', FigurePicture)
