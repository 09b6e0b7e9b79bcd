import { html, LitElement, nothing } from 'lit'
import { PaletteReader } from '../../view/palette.ts'
import type { Palette } from '../../view/palette.ts'
import { pointIn } from '../../ui/input.ts'
import { tableFold } from '../../ui/tableFold.ts'
import { onRestyle } from '../../ui/theme.ts'
import type { Playback } from '../../lab/playback/playback.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import { boxOf, drawChart } from './chart.ts'
import { drawCursor, timeAt } from './cursor.ts'
import { drawingOf } from './curves.ts'
import type { PlotDrawing } from './curves.ts'
import type { PlotKind } from './kinds.ts'
import { inFull, plotValues, readingsAt, spoken } from './readings.ts'
import { plotTable } from './table.ts'

/** The time that readings have to stand still before they are told [ms]. */
const PAUSE = 300

/**
 * One plot: a chart that is made when it comes near the window, the values at the cursor, and a table. Nothing is
 * worked out while it can't be seen.
 *
 * - `kind`: which plot
 * - `simulated`: what it shows
 * - `time`: of the transport, as it is read [s]; `playback`: the same at every frame
 * - `hover`: of the pointer, over whichever plot it is
 * - `selected`: the index of the runner that is drawn stronger
 * - `seek`, `point`: called with the time that is clicked on, and pointed at
 */
class LabPlot extends LitElement {
  static override properties = {
    kind: { attribute: false },
    simulated: { attribute: false },
    time: { attribute: false },
    hover: { attribute: false },
    selected: { attribute: false },
    told: { state: true },
    near: { state: true },
  }

  declare kind: PlotKind
  declare simulated: Simulated
  declare time: number
  /** Not reactive: it is the same for good. */
  declare playback: Playback
  declare hover: number | undefined
  declare selected: number
  /** Not reactive: fresh closures are no reason to draw again. */
  declare seek: (time: number) => void
  declare point: (time: number | undefined) => void
  /** The readings in words, for those who moved the cursor from here. */
  declare private told: string
  /** Whether it has come near the window. */
  declare private near: boolean
  private readonly fold = tableFold(this)
  private readonly colours = new PaletteReader(this)
  private drawing: PlotDrawing | undefined
  private drawn: unknown[] = []
  private area: HTMLElement | undefined
  /** Of the area, kept so that no frame has to ask for the layout [px]. */
  private width = 0
  private height = 0
  private readonly sizes = new ResizeObserver(([entry]) => {
    this.width = entry!.contentRect.width
    this.height = entry!.contentRect.height
    this.requestUpdate()
  })
  private seen = false
  private palette: Palette | undefined
  private timer: ReturnType<typeof setTimeout> | undefined
  private stopWatching = () => {}

  constructor() {
    super()
    this.told = ''
    this.near = false
  }

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    const near = new IntersectionObserver(
      ([entry]) => {
        if (entry!.isIntersecting) this.near = true
      },
      { rootMargin: '100% 0px' },
    )
    const seen = new IntersectionObserver(([entry]) => {
      this.seen = entry!.isIntersecting
      if (this.seen) this.requestUpdate()
    })
    for (const observer of [near, seen]) observer.observe(this)
    if (this.area) this.sizes.observe(this.area)
    const redraw = () => {
      this.drawn = []
      this.requestUpdate()
    }
    const stopStyles = onRestyle(redraw)
    const stopTime = this.playback.subscribe(this, 'draw', () => this.drawCursor())
    this.stopWatching = () => {
      stopTime()
      for (const observer of [near, seen, this.sizes]) observer.disconnect()
      stopStyles()
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
    clearTimeout(this.timer)
  }

  override shouldUpdate(): boolean {
    return this.seen || !this.hasUpdated || (this.near && !this.drawing)
  }

  override render() {
    const { kind, simulated, hover, time, near } = this
    const readings = near ? readingsAt(kind, simulated, hover ?? time) : []
    const { over, title } = kind
    return html`<figure>
      <figcaption>
        <h3>${title}</h3>
        <p>${kind.caption(simulated)}</p>
      </figcaption>
      <div
        class="area"
        role="group"
        tabindex="0"
        aria-label="${title}${over ? '' : ' over time'}. The arrow keys go from frame to frame."
        @pointermove=${this.move}
        @pointerleave=${() => this.point(undefined)}
        @pointerdown=${this.press}
      >
        ${near ? html`<canvas class="chart"></canvas> <canvas class="cursor"></canvas>` : nothing}
      </div>
      ${plotValues(kind, simulated, readings, this.writeOut)}
      <output class="visually-hidden">${this.told}</output>
      ${this.fold(title, () => plotTable(kind, simulated))}
    </figure>`
  }

  override firstUpdated(): void {
    this.area = this.querySelector<HTMLElement>('.area')!
    this.sizes.observe(this.area)
  }

  override updated(changed: Map<PropertyKey, unknown>): void {
    this.draw()
    if (changed.has('time') && this.matches(':focus-within')) this.tell()
  }

  /** Every digit, for the one who points at a value: to write all of them at every frame would cost too much. */
  private readonly writeOut = (event: PointerEvent): void => {
    const item = (event.target as Element).closest('li')
    const { kind, simulated, time } = this
    const reading = item && readingsAt(kind, simulated, time)[Number(item.dataset.index)]
    if (reading) item.title = inFull(kind, reading)
  }

  private draw(): void {
    const { near, kind, simulated, selected, width, height } = this
    if (!near || width === 0) return
    const wanted = [simulated, selected, width, height]
    if (wanted.some((each, i) => each !== this.drawn[i])) {
      this.drawn = wanted
      this.drawing = drawingOf(kind, simulated, width, height)
      this.palette = this.colours.read()
      const style = { palette: this.palette, selected, width, height }
      drawChart(this.querySelector('canvas.chart')!, this.drawing, style)
    }
    this.drawCursor()
  }

  private drawCursor(): void {
    const { drawing, palette, kind, simulated, width, height, hover } = this
    const { time } = this.playback
    const canvas = this.querySelector<HTMLCanvasElement>('canvas.cursor')
    // Until it has come near, and until the chart shows the same.
    if (!canvas || !drawing || this.drawn[0] !== simulated) return
    const readings = readingsAt(kind, simulated, hover ?? time)
    drawCursor(canvas, { drawing, width, height, time, hover, readings }, palette!)
  }

  private tell(): void {
    clearTimeout(this.timer)
    this.timer = setTimeout(() => {
      const { kind, simulated, time } = this
      this.told = spoken(kind, readingsAt(kind, simulated, time), time)
    }, PAUSE)
  }

  private readonly press = (event: PointerEvent): void => {
    const time = this.timeOf(event)
    if (event.button !== 0 || time === undefined) return
    ;(event.currentTarget as HTMLElement).setPointerCapture(event.pointerId)
    this.seek(time)
  }

  private readonly move = (event: PointerEvent): void => {
    const time = this.timeOf(event)
    if (time === undefined) return
    if (event.buttons & 1) this.seek(time)
    this.point(event.pointerType === 'mouse' ? time : undefined)
  }

  private timeOf(event: PointerEvent): number | undefined {
    const { drawing, width, height } = this
    if (!drawing) return undefined
    const at = pointIn(event.currentTarget as HTMLElement, event)
    return timeAt(drawing, boxOf(width, height), at)
  }
}

customElements.define('slide-lab-plot', LabPlot)
