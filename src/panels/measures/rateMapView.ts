import { html, LitElement, nothing } from 'lit'
import type { ReactiveControllerHost } from 'lit'
import { guard } from 'lit/directives/guard.js'
import type { ResolvedExperiment } from '../../physics/index.ts'
import { mappedExperiment } from '../../measure/index.ts'
import type { MapRequest, MapRow, Method } from '../../measure/index.ts'
import { tableFold } from '../../ui/tableFold.ts'
import type { Measured } from './loading.ts'
import { MapCells } from './mapCells.ts'
import { mapLegend, isDark, keepPainted } from './mapImage.ts'
import { mapControls, mapRequest, parameterFor } from './mapChoice.ts'
import { cellUnder, mapDrawing, mapFrame, mapPlaceOf } from './mapDrawing.ts'
import type { MapFrame, MapPlace } from './mapDrawing.ts'
import { mapTable, cellWords, limitWords, placeText, summary } from './mapWords.ts'
import type { MapChoice } from './mapChoice.ts'
import { Measuring } from './measuring.ts'
import { areaSize, arrows, pictureChoice } from './pictureArea.ts'
import type { PictureChoice } from './pictureArea.ts'

/**
 * A map of a method's error over frame rates and a parameter, measured while it can be seen.
 *
 * - `experiment`: the selected runner's, with nothing left out
 * - `paletteIndex`: the runner's, for the mark that says where it is
 * - `load`: called with the run that the reader wants to see
 */
class RateMap extends LitElement implements MapChoice {
  static override properties = {
    experiment: { attribute: false },
    paletteIndex: { attribute: false },
    method: { state: true },
    of: { state: true },
    parameter: { state: true },
  }

  declare experiment: ResolvedExperiment
  declare paletteIndex: number
  /** Not reactive: a fresh closure is no reason to draw again. */
  declare load: (measured: Measured) => void
  /** What is measured of the map that is seen. */
  cells!: MapCells
  /** The runner's own, until the reader chooses another. */
  declare method: Method
  declare of: MapRequest['of']
  declare parameter: string
  private methodKey = ''
  private readonly size = areaSize(this)
  private readonly cross = mapCross(this)
  private readonly fold = tableFold(this)
  private readonly measuring: Measuring = new Measuring(this, ({ request }, parts, fresh) => {
    if (fresh) this.cells = new MapCells(request as MapRequest)
    for (const row of parts) this.cells.take(row as MapRow)
  })

  constructor() {
    super()
    this.of = 'error'
    this.parameter = ''
    keepPainted(this)
  }

  override createRenderRoot(): this {
    return this
  }

  override willUpdate(): void {
    const { integrator, stopping, timestep } = this.experiment
    const own = { integrator, stopping, timestep }
    const key = JSON.stringify(own)
    if (key !== this.methodKey) this.method = own
    this.methodKey = key
    this.parameter = parameterFor(this.experiment, this.parameter)
    const { request } = this
    this.measuring.want({ kind: 'map', request })
    // It takes all its room before anything is measured.
    this.cells ??= new MapCells(request)
  }

  private get request(): MapRequest {
    return mapRequest(this)
  }

  /** Where the image lies in the picture. */
  get frame(): MapFrame {
    return mapFrame(this.size.width, this.size.height)
  }

  override render() {
    const { measuring, cross, cells, frame } = this
    const dark = isDark(this)
    const { request } = cells
    const { width, left, top, right, bottom } = frame
    const shown = request.parameter === this.parameter ? cross.chosen : undefined
    return html`<div class="measure" ?data-busy=${measuring.busy}>
      ${mapControls(this, this.change, measuring)}
      ${cross.area(html`
        <canvas
          width=${request.columns}
          height=${request.rows}
          aria-hidden="true"
          .style="left: ${left}px; top: ${top}px; width: ${Math.max(0, right - left)}px; height: ${bottom - top}px"
        ></canvas>
        ${width > 0 ? mapDrawing(request, frame, this.here(), shown) : nothing}
      `)}
      ${guard([cells, cells.version, dark], () => mapLegend(cells, dark, limitWords(request)))}
      <p class="read-out">${this.readOut(shown)}</p>
      <output class="visually-hidden">${cross.told}</output>
      ${this.fold('frame-rate map', () => mapTable(cells))}
    </div>`
  }

  private readOut(shown: MapPlace | undefined) {
    const { cells, measuring } = this
    const { request } = cells
    return shown
      ? html`<b>${placeText(request, shown.column, shown.row)}:</b> the run
          ${cellWords(cells.cell(shown.column, shown.row), request)}.
          <span class="soft">Click to see it in the lab.</span>`
      : html`<span class="soft"
          >${measuring.done === 1 ? guard([cells, cells.version], () => summary(cells)) : ''}</span
        >`
  }

  private readonly change = (choice: Partial<MapChoice>): void => {
    Object.assign(this, choice)
    // Its place would be that of another value.
    if (choice.parameter) this.cross.choose(undefined)
  }

  private here() {
    const { frames, parameters } = this.experiment
    if (!('fps' in frames)) return undefined
    const place = mapPlaceOf(this.request, frames.fps, parameters[this.parameter]!)
    return place && { ...place, paletteIndex: this.paletteIndex }
  }

  /** Has the run of a cell shown, if it can be run. */
  show({ column, row }: MapPlace): void {
    const { cells } = this
    const cell = cells.cell(column, row)
    if (cell.kind === 'refused') return
    this.load({
      experiment: mappedExperiment(cells.request, column, row),
      label: placeText(cells.request, column, row),
      words: `The run ${cellWords(cell, cells.request)}.`,
    })
  }
}

/** A map in which a cell can be chosen. */
interface Host extends ReactiveControllerHost {
  readonly cells: MapCells
  readonly frame: MapFrame
  show(place: MapPlace): void
}

/** Where the cross hair of a map is. */
function mapCross(host: Host): PictureChoice<MapPlace> {
  return pictureChoice(host, {
    label:
      'Frame-rate map. The arrow keys move the cross hair, with Shift by ten, Enter shows the run in the lab.',
    moves: arrows,
    at: (x, y) => cellUnder(host.cells.request, host.frame, x, y),
    next: (from, [across, up], shift) => {
      const { columns, rows } = host.cells.request
      const { column, row } = from ?? { column: columns / 2, row: rows / 2 }
      const steps = shift ? 10 : 1
      return {
        column: Math.max(0, Math.min(columns - 1, column + across * steps)),
        row: Math.max(0, Math.min(rows - 1, row + up * steps)),
      }
    },
    words: ({ column, row }) => {
      const { request } = host.cells
      return `${placeText(request, column, row)}: the run ${cellWords(host.cells.cell(column, row), request)}.`
    },
    show: (place) => {
      if (place) host.show(place)
      return true
    },
  })
}

customElements.define('slide-rate-map', RateMap)
