import { html, LitElement, nothing } from 'lit'
import { guard } from 'lit/directives/guard.js'
import { integrators, scenes, stoppings, timesteps } from '../../physics/index.ts'
import type { Experiment, ResolvedExperiment, Scene } from '../../physics/index.ts'
import { mappedExperiment, REFERENCE_RATE, stableRate } from '../../measure/index.ts'
import type { MapRequest, MapRow, MethodChoice } from '../../measure/index.ts'
import { PaletteReader } from '../../view/palette.ts'
import { menu } from '../menu.ts'
import { choose } from '../state.ts'
import type { RunnerState } from '../state.ts'
import { onThemeChange } from '../theme.ts'
import type { Measured } from './loading.ts'
import { MapCells } from './mapCells.ts'
import { cellUnder, mapDrawing, mapFrame, placeOf } from './mapDrawing.ts'
import type { MapPlace } from './mapDrawing.ts'
import { paintMap } from './mapImage.ts'
import { mapLegend } from './mapLegend.ts'
import { mapTable } from './mapTable.ts'
import { cellWords, placeText, summary } from './mapWords.ts'
import { Measuring } from './measuring.ts'
import { progress } from './progress.ts'
import { sharedExperiment } from './sharedExperiment.ts'

const COLUMNS = 160
const ROWS = 120

/** What most of a scene depends on, where it is not its first parameter. */
const telling = ['stiffness', 'drag', 'radius', 'angle']

/**
 * A map of a method's error over frame rates and a parameter, measured while it can be seen.
 *
 * - `experiment`: the selected runner's, with nothing left out
 * - `look`: the runner's, for the mark that says where it is
 * - `load`: called with the run that the reader wants to see
 */
export class RateMap extends LitElement {
  static override properties = {
    experiment: { attribute: false },
    look: { attribute: false },
    method: { state: true },
    of: { state: true },
    parameter: { state: true },
    cross: { state: true },
    told: { state: true },
    listed: { state: true },
    width: { state: true },
  }

  declare experiment: ResolvedExperiment
  declare look: number
  /** Not reactive: a fresh closure is no reason to draw again. */
  declare load: (measured: Measured) => void
  /** The runner's own, until the reader chooses another. */
  declare private method: MethodChoice
  declare private of: MapRequest['of']
  declare private parameter: string
  declare private cross: MapPlace | undefined
  declare private told: string
  declare private listed: boolean
  declare private width: number
  private methodKey = ''
  private cells!: MapCells
  /** What the image was painted from. */
  private painted: unknown[] = []
  private readonly colours = new PaletteReader(this)
  /** It follows from the width [px]. */
  private height = 0
  private readonly sizes = new ResizeObserver(([entry]) => {
    const { width, height } = entry!.contentRect
    this.height = height
    this.width = Math.round(width)
  })
  private stopThemes = () => {}
  private readonly measuring: Measuring = new Measuring(this, ({ request }, parts, fresh) => {
    if (fresh) this.cells = new MapCells(request as MapRequest)
    for (const row of parts) this.cells.take(row as MapRow)
  })

  constructor() {
    super()
    this.of = 'error'
    this.parameter = ''
    this.told = ''
    this.listed = false
    this.width = 0
  }

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    this.stopThemes = onThemeChange(() => this.requestUpdate())
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopThemes()
    this.sizes.disconnect()
  }

  override willUpdate(): void {
    const { integrator, stopping, timestep } = this.experiment
    const own = { integrator, stopping, timestep }
    const key = JSON.stringify(own)
    if (key !== this.methodKey) this.method = own
    this.methodKey = key
    const names = Object.keys(this.scene.parameters)
    if (!names.includes(this.parameter))
      this.parameter = telling.find((name) => names.includes(name)) ?? names[0]!
    const { request } = this
    this.measuring.want({ kind: 'map', request })
    // As yet without a figure, it has all its room.
    this.cells ??= new MapCells(request)
  }

  override updated(): void {
    this.sizes.observe(this.querySelector('.area')!)
    const canvas = this.querySelector('canvas')
    const palette = this.colours.read()
    const wanted = [this.cells, this.cells.version, palette]
    if (!canvas || wanted.every((each, i) => each === this.painted[i])) return
    this.painted = wanted
    paintMap(canvas, this.cells, palette, this.isDark)
  }

  private get scene(): Scene {
    return scenes.find(({ id }) => id === this.experiment.scene)!
  }

  private get isDark(): boolean {
    return getComputedStyle(this).colorScheme === 'dark'
  }

  private get request(): MapRequest {
    const { from, to } = this.scene.parameters[this.parameter]!.slider
    const { min } = this.scene.parameters[this.parameter]!
    return {
      experiment: {
        ...sharedExperiment(this.experiment as Experiment),
        ...this.method,
      } as Experiment,
      of: this.of,
      parameter: this.parameter,
      ...{ from: Math.max(from, min), to, slowest: 5, fastest: 240, columns: COLUMNS, rows: ROWS },
    }
  }

  override render() {
    const { width, height, measuring, cross, cells } = this
    const { request } = cells
    const frame = mapFrame(width, height)
    const { left, top, right, bottom } = frame
    const shown = this.isCurrent(request) ? cross : undefined
    return html`<div class="measure" ?data-busy=${measuring.busy}>
      ${this.controls()}
      <div
        class="area"
        role="group"
        tabindex="0"
        aria-label="Frame-rate map. The arrow keys move the cross hair, with Shift by ten, Enter shows the run in the lab."
        @pointermove=${(event: PointerEvent) => (this.cross = this.under(event))}
        @pointerleave=${() => (this.cross = undefined)}
        @click=${(event: MouseEvent) => this.show(this.under(event))}
        @keydown=${this.pressed}
      >
        <canvas
          width=${COLUMNS}
          height=${ROWS}
          aria-hidden="true"
          .style="left: ${left}px; top: ${top}px; width: ${Math.max(0, right - left)}px; height: ${bottom - top}px"
        ></canvas>
        ${width > 0 ? mapDrawing(request, frame, this.here(), shown) : nothing}
      </div>
      ${guard([cells, cells.version, this.isDark], () =>
        mapLegend(cells, this.isDark, this.limitWords(request)),
      )}
      <p class="read-out">
        ${
          shown
            ? html`<b>${placeText(request, shown.column, shown.row)}:</b> the run
                ${cellWords(cells.cell(shown.column, shown.row), request)}.
                <span class="soft">Click to see it in the lab.</span>`
            : html`<span class="soft"
                >${
                  measuring.done === 1 ? guard([cells, cells.version], () => summary(cells)) : ''
                }</span
              >`
        }
      </p>
      <output class="visually-hidden">${this.told}</output>
      <details
        @toggle=${(event: Event) => (this.listed = (event.target as HTMLDetailsElement).open)}
      >
        <summary>As a table<span class="visually-hidden">: frame-rate map</span></summary>
        ${this.listed ? mapTable(cells) : nothing}
      </details>
    </div>`
  }

  private controls() {
    const { method, scene, parameter, of, measuring } = this
    const set = (values: Partial<MethodChoice>) => {
      this.method = { ...method, ...values } as MethodChoice
      return true
    }
    const parameters = Object.entries(scene.parameters).map(([id, { label }]) => {
      return { id, label, about: `What runs upwards: ${label.toLowerCase()}` }
    })
    return html`<div class="measure-controls">
      <div class="segments" role="group" aria-label="What the colours show">
        ${(['error', 'spread'] as const).map(
          (id) =>
            html`<button type="button" aria-pressed=${id === of} @click=${() => (this.of = id)}>
              ${id === 'error' ? 'Error' : `Spread against ${REFERENCE_RATE} fps`}
            </button>`,
        )}
      </div>
      <label class="choose"
        >Frame rate ×
        ${menu({
          label: 'Parameter of the map',
          list: parameters,
          chosen: parameter,
          pick: (id) => {
            this.parameter = id
            this.cross = undefined
            return true
          },
        })}
      </label>
      <span class="choose">
        ${menu({
          label: 'Integrator of the map',
          list: integrators,
          chosen: method.integrator,
          pick: (id) => set({ integrator: id as MethodChoice['integrator'] }),
        })}
        ${menu({
          label: 'Stopping rule of the map',
          list: stoppings,
          chosen: method.stopping,
          pick: (id) => set({ stopping: id as MethodChoice['stopping'] }),
        })}
        ${menu({
          label: 'Time step of the map',
          list: timesteps,
          chosen: method.timestep.kind,
          pick: (id) =>
            set({ timestep: choose('timestep', id, method.timestep as RunnerState['timestep']) }),
        })}
      </span>
      ${progress(measuring)}
    </div>`
  }

  /** What theory says of the runs on the map, where it says something. */
  private limitWords(request: MapRequest): string {
    const rate = stableRate(mappedExperiment(request, 0, request.rows - 1))
    if (rate === undefined) return ''
    if (rate === Infinity) return 'Theory: blows up at every frame rate, sooner or later'
    if (rate === 0) return 'Theory: blows up at none'
    return 'Theory, without friction: blows up left of this line'
  }

  private here() {
    const { frames, parameters } = this.experiment
    if (!('fps' in frames)) return undefined
    const place = placeOf(this.request, frames.fps, parameters[this.parameter]!)
    return place && { ...place, look: this.look }
  }

  private isCurrent(request: MapRequest): boolean {
    return request.parameter === this.parameter
  }

  private under({ clientX, clientY }: MouseEvent): MapPlace | undefined {
    const area = this.querySelector<HTMLElement>('.area')!
    const { left, top } = area.getBoundingClientRect()
    const frame = mapFrame(this.width, this.height)
    return cellUnder(this.request, frame, clientX - left, clientY - top)
  }

  private readonly pressed = (event: KeyboardEvent): void => {
    const { key, ctrlKey, metaKey, altKey, shiftKey } = event
    if (ctrlKey || metaKey || altKey) return
    const moves: Record<string, readonly [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, 1],
      ArrowDown: [0, -1],
    }
    const move = moves[key]
    if (key === 'Enter' || key === ' ') this.show(this.cross)
    else if (!move) return
    else this.go(move, shiftKey ? 10 : 1)
    // The lab's own keys move its transport.
    event.preventDefault()
    event.stopPropagation()
  }

  private go([across, up]: readonly [number, number], steps: number): void {
    const { columns, rows } = this.request
    const { column, row } = this.cross ?? { column: columns / 2, row: rows / 2 }
    this.cross = {
      column: Math.max(0, Math.min(columns - 1, column + across * steps)),
      row: Math.max(0, Math.min(rows - 1, row + up * steps)),
    }
    const { cells, cross } = this
    this.told = `${placeText(cells.request, cross.column, cross.row)}: the run ${cellWords(cells.cell(cross.column, cross.row), cells.request)}.`
  }

  private show(place: MapPlace | undefined): void {
    const { cells } = this
    if (!place) return
    const { column, row } = place
    const cell = cells.cell(column, row)
    if (cell.kind === 'refused') return
    this.load({
      experiment: mappedExperiment(cells.request, column, row),
      label: placeText(cells.request, column, row),
      words: `The run ${cellWords(cell, cells.request)}.`,
    })
  }
}
