import { html, LitElement, nothing } from 'lit'
import { measureScale } from '../chart/pen.ts'
import type { NumberOption } from '../physics/index.ts'
import { shownNumber } from '../chart/numbers.ts'
import type { ForceDrawing } from '../view/forces.ts'
import type { Handle, HandleId, Picture } from '../view/picture.ts'
import { Stage } from '../view/stage.ts'
import { pointIn, valueByKey } from '../ui/input.ts'
import { onRestyle } from '../ui/theme.ts'
import type { Playback } from './playback/playback.ts'

const purposes: Readonly<Record<HandleId, string>> = {
  tilt: 'Tilt the track',
  place: 'Place the block',
  push: 'Push the block',
}

/**
 * The picture, and over each handle drawn in it a target that mouse, finger and keyboard can take hold of.
 *
 * - `picture`: what it shows at an instant [s]
 * - `playback`: the instant
 * - `description`: the same in words
 * - `forceDrawing`: what draws its forces; undefined until it is loaded
 * - `change`: called with the parameters that a handle was moved to
 */
export class SlideStage extends LitElement {
  static override properties = {
    picture: { attribute: false },
    playback: { attribute: false },
    description: { attribute: false },
    forceDrawing: { attribute: false },
    held: { state: true },
    lit: { state: true },
  }

  declare picture: (time: number) => Omit<Picture, 'held' | 'lit'>
  declare playback: Playback
  declare description: string
  declare forceDrawing: ForceDrawing | undefined
  /** Not reactive: a fresh closure is no reason to draw again. */
  declare change: (values: Readonly<Record<string, number>>) => void
  declare private held: HandleId | undefined
  declare private lit: HandleId | undefined
  private readonly canvas = document.createElement('canvas')
  private readonly stage = new Stage(this.canvas)
  /** From where a handle was taken hold of to its middle, so that it does not leap under the finger. */
  private grip = { x: 0, y: 0 }
  private stopWatching = () => {}

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    const redraw = () => {
      measureScale(this.canvas)
      this.stage.refresh()
      this.requestUpdate()
    }
    const recolour = () => {
      redraw()
      // At once: before it prints, Firefox runs no microtask.
      if (this.hasUpdated) this.draw()
    }
    const sizes = new ResizeObserver(redraw)
    sizes.observe(this.canvas)
    // A deck of slides scales them to the window.
    addEventListener('resize', redraw)
    const stopStyles = onRestyle(recolour)
    const stopTime = this.playback.subscribe(this, 'draw', () => this.draw())
    this.stopWatching = () => {
      stopTime()
      sizes.disconnect()
      removeEventListener('resize', redraw)
      stopStyles()
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
  }

  override willUpdate(): void {
    // Before rendering, since where the handles stand follows from the picture.
    this.canvas.role = 'img'
    this.canvas.ariaLabel = this.description
    this.draw()
  }

  private draw(): void {
    const { picture, playback, held, lit, forceDrawing } = this
    this.stage.draw({ ...picture(playback.time), held, lit: held ?? lit }, forceDrawing)
  }

  override render() {
    const picture = this.picture(this.playback.time)
    const { handles } = this.stage
    // Each in a place of its own, so that one under a finger stays the element that it is.
    return html`${this.canvas}${(Object.keys(purposes) as HandleId[]).map((id) => {
      const handle = handles.find((each) => each.id === id)
      return handle ? this.target(handle, picture) : nothing
    })}`
  }

  private target(handle: Handle, { scene, parameters }: Pick<Picture, 'scene' | 'parameters'>) {
    const { id, x, y, parameter } = handle
    const option = scene.parameters[parameter]!
    const value = parameters[parameter]!
    const { from, to } = option.slider
    return html`<div
      class="handle"
      role="slider"
      tabindex="0"
      data-handle=${id}
      .style="left: ${x}px; top: ${y}px"
      aria-label="${purposes[id]}: ${option.label.toLowerCase()}"
      aria-valuemin=${Math.min(from, value)}
      aria-valuemax=${Math.max(to, value)}
      aria-valuenow=${value}
      aria-valuetext="${shownNumber(value)} ${option.unit}"
      @pointerenter=${() => (this.lit = id)}
      @pointerleave=${() => (this.lit = undefined)}
      @focus=${() => (this.lit = id)}
      @blur=${() => (this.lit = undefined)}
      @pointerdown=${(event: PointerEvent) => this.take(event, handle)}
      @pointermove=${this.move}
      @lostpointercapture=${this.letGo}
      @keydown=${(event: KeyboardEvent) => this.press(event, parameter, option, value)}
    ></div>`
  }

  private take(event: PointerEvent, { id, x, y }: Handle): void {
    if (event.button !== 0) return
    ;(event.currentTarget as HTMLElement).setPointerCapture(event.pointerId)
    const at = pointIn(this.canvas, event)
    this.grip = { x: x - at.x, y: y - at.y }
    this.stage.frozen = true
    this.held = id
  }

  private readonly move = (event: PointerEvent): void => {
    if (!this.held) return
    const { x, y } = pointIn(this.canvas, event)
    this.change(this.stage.drag(this.held, x + this.grip.x, y + this.grip.y))
  }

  private readonly letGo = (): void => {
    this.stage.frozen = false
    this.held = undefined
  }

  private press(
    event: KeyboardEvent,
    parameter: string,
    { slider, min, max }: NumberOption,
    value: number,
  ): void {
    const next = valueByKey(event, slider, value)
    if (next === undefined) return
    event.preventDefault()
    this.change({ [parameter]: Math.min(max, Math.max(min, next)) })
  }
}
