import { html, LitElement, nothing } from 'lit'
import { integrators, stoppings } from '../../physics/index.ts'
import type { Experiment, StoppingId } from '../../physics/index.ts'
import { sweepMethods, sweepRates, sweptExperiment } from '../../measure/index.ts'
import type { SweepCurve, SweepRequest, TimedCurve } from '../../measure/index.ts'
import { plain, raw } from '../../view/numbers.ts'
import { menu } from '../menu.ts'
import type { SimulatedRunner } from '../simulation.ts'
import { costKinds } from './costs.ts'
import { diagramDrawing } from './diagramDrawing.ts'
import { layOut, nearestSpot, rowsOf } from './diagramLayout.ts'
import type { DiagramLayout, Spot } from './diagramLayout.ts'
import { diagramTable } from './diagramTable.ts'
import { advice, errorText, leastError, pointName, pointWords } from './diagramWords.ts'
import { labRunners } from './labRunners.ts'
import type { LabRunner } from './labRunners.ts'
import { loadByAddress } from './loading.ts'
import type { Measured } from './loading.ts'
import { Measuring } from './measuring.ts'
import { diagramCurves } from './points.ts'
import type { DiagramCurve, DiagramPoint } from './points.ts'
import { progress } from './progress.ts'
import { roughSize } from './scale.ts'
import { sharedExperiment } from './sharedExperiment.ts'
import type { Part, Task } from './task.ts'

/**
 * Speed against error: what each method costs in a scene, and the error that this buys, measured while it can be seen.
 *
 * - attribute or property `experiment`: the scene, its parameters and the duration, as JSON; its method and frames say
 *   nothing
 * - `runners`: of the lab that it stands in, to be seen among the curves
 * - `load`: called with the run that the reader wants to see; without it the page's own lab shows it
 */
export class SpeedDiagram extends LitElement {
  static override properties = {
    experiment: { type: Object },
    runners: { attribute: false },
    stopping: { state: true },
    cost: { state: true },
    chosen: { state: true },
    told: { state: true },
    listed: { state: true },
    width: { state: true },
  }

  declare experiment: Experiment
  declare runners: readonly SimulatedRunner[]
  /** Not reactive: a fresh closure is no reason to draw again. */
  load: (measured: Measured) => void = loadByAddress
  declare private stopping: StoppingId
  declare private cost: 'evaluations' | 'time'
  /** The point that is read, by what it is called. */
  declare private chosen: string | undefined
  /** The same in words, for those who go there by keys. */
  declare private told: string
  declare private listed: boolean
  /** Of the picture [px]. */
  declare private width: number
  /** It follows from the width. */
  private height = 0
  private readonly sizes = new ResizeObserver(([entry]) => {
    const { width, height } = entry!.contentRect
    this.height = height
    this.width = Math.round(width)
  })
  private sweptKey = ''
  private swept = new Map<string, SweepCurve>()
  private timedKey = ''
  private timed = new Map<string, TimedCurve>()
  private layout: DiagramLayout | undefined
  /** The curves are those of what is asked for now. */
  private current = false
  private readonly measuring: Measuring = new Measuring(this, (task, parts, fresh) =>
    this.take(task, parts, fresh),
  )

  constructor() {
    super()
    this.experiment = { scene: 'half-pipe' }
    this.stopping = 'located'
    this.cost = 'evaluations'
    this.told = ''
    this.listed = false
    this.runners = []
    this.width = 0
  }

  override createRenderRoot(): this {
    return this
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.sizes.disconnect()
  }

  override updated(): void {
    const area = this.querySelector('.area')
    if (area) this.sizes.observe(area)
  }

  override willUpdate(): void {
    const { request } = this
    const key = JSON.stringify(request)
    this.current = this.sweptKey === key
    const whole = this.current && this.swept.size === request.methods.length
    const timed = this.timedKey === key && this.timed.size === request.methods.length
    if (request.experiment.duration === 0) this.measuring.want(undefined)
    else if (!whole) this.measuring.want({ kind: 'sweep', request })
    else if (this.cost === 'time' && !timed) this.measuring.want({ kind: 'timing', request })
    else this.measuring.want(undefined)
  }

  private get request(): SweepRequest {
    return {
      experiment: { ...sharedExperiment(this.experiment), stopping: this.stopping },
      methods: sweepMethods,
      rates: sweepRates,
    }
  }

  private take(task: Task, parts: readonly Part[], fresh: boolean): void {
    const key = JSON.stringify(task.request)
    if (task.kind === 'sweep') {
      if (fresh) this.swept = new Map()
      this.sweptKey = key
      for (const part of parts as SweepCurve[]) this.swept.set(part.method, part)
    } else {
      if (fresh) this.timed = new Map()
      this.timedKey = key
      for (const part of parts as TimedCurve[]) this.timed.set(part.method, part)
    }
  }

  private get curves(): DiagramCurve[] {
    const { cost, timed, sweptKey, timedKey } = this
    return diagramCurves([...this.swept.values()], sweepRates, (curve) =>
      cost === 'evaluations'
        ? curve.evaluations
        : sweptKey === timedKey
          ? timed.get(curve.method)?.nanoseconds
          : undefined,
    )
  }

  override render() {
    const { request, width, height, cost, stopping, measuring } = this
    const kind = costKinds.find(({ id }) => id === cost)!
    const { curves } = this
    const runners = labRunners(
      this.runners,
      { stopping, duration: request.experiment.duration! },
      cost === 'time' ? curves : undefined,
    )
    const points = runners.flatMap(({ point }) => (point && this.current ? [point] : []))
    this.layout =
      width > 0 && curves.length > 0 ? layOut(curves, { width, height }, points) : undefined
    const spot = this.spot()
    return html`<div class="measure" ?data-busy=${measuring.busy}>
      <div class="measure-controls">
        <div class="segments" role="group" aria-label="What a simulated second costs">
          ${costKinds.map(
            ({ id, label, about }) =>
              html`<button
                type="button"
                aria-pressed=${id === cost}
                title=${about}
                @click=${() => (this.cost = id)}
              >
                ${label}
              </button>`,
          )}
        </div>
        <label class="choose">
          Stops
          ${menu({
            label: 'Stopping rule of the diagram',
            list: stoppings,
            chosen: stopping,
            pick: (id) => {
              this.stopping = id as StoppingId
              return true
            },
          })}
        </label>
        ${progress(measuring)}
      </div>
      <div
        class="area"
        role="group"
        tabindex="0"
        aria-label="Speed against error. Left and right go along a curve, up and down to another, Enter shows the run in the lab."
        @pointermove=${this.point}
        @pointerleave=${() => (this.chosen = undefined)}
        @click=${this.clicked}
        @keydown=${this.pressed}
      >
        ${this.layout ? diagramDrawing(this.layout, kind, spot) : nothing}
        ${request.experiment.duration === 0 ? html`<p class="absent">A run of 0 s costs nothing and is never wrong.</p>` : nothing}
      </div>
      ${this.key(curves)} ${runners.length > 0 ? this.rings(runners) : nothing}
      <p class="read-out">
        ${
          spot
            ? html`<b>${pointName(spot.point)}</b>: ${pointWords(spot.point, kind)}.
                ${spot.point.runner ? nothing : html`<span class="soft">Click to see it in the lab.</span>`}`
            : html`<span class="soft"
                >Further down is better, further left is cheaper; the grey band joins the best.
                Point at a mark to read it.</span
              >`
        }
      </p>
      <output class="visually-hidden">${this.told}</output>
      <details
        @toggle=${(event: Event) => (this.listed = (event.target as HTMLDetailsElement).open)}
      >
        <summary>As a table<span class="visually-hidden">: speed against error</span></summary>
        ${this.listed ? diagramTable(curves, points, kind) : nothing}
      </details>
      ${this.advice(curves, kind.label)}
    </div>`
  }

  /** Its room is known before the curves are. */
  private key(curves: readonly DiagramCurve[]) {
    return html`<ul class="key curve-key">
      ${integrators.map(
        ({ id, label, colour }) =>
          html`<li>
            <runner-mark .look=${colour}></runner-mark> ${label}
            <span class="soft">${curves.find(({ method }) => method === id)?.order}</span>
          </li>`,
      )}
    </ul>`
  }

  private rings(runners: readonly LabRunner[]) {
    return html`<ul class="key ring-key">
      <li class="soft">Rings: the lab’s runners</li>
      ${runners.map(
        ({ name, look, point, why }) =>
          html`<li title=${point ? `${raw(point.error)} m` : ''}>
            <runner-mark .look=${look}></runner-mark> ${name}
            <span class="soft">${point ? errorText(point) : `no ring: ${why}`}</span>
          </li>`,
      )}
      ${
        runners.some(({ point }) => point?.runner!.apart)
          ? html`<li class="soft">Dashed: stops or steps otherwise than the curves</li>`
          : nothing
      }
    </ul>`
  }

  private advice(curves: readonly DiagramCurve[], cost: string) {
    const found = advice(curves)
    const least = leastError(curves)
    return html`<div class="advice">
      <p class="title">What to use here <span class="soft">by ${cost.toLowerCase()}</span></p>
      <ul>
        ${found.map(
          ({ error, point }) =>
            html`<li>
              For <b>${error}</b>, use
              <button type="button" class="in-text" @click=${() => this.show(point)}>
                ${pointName(point)}</button
              >.
            </li>`,
        )}
      </ul>
      ${
        found.length > 0 && least > 1e-9
          ? html`<p class="soft">
              Nothing here comes nearer than ${roughSize(least)} with up to
              ${plain(sweepRates.at(-1)!)} steps a second.
            </p>`
          : nothing
      }
    </div>`
  }

  private spot(): Spot | undefined {
    const { chosen, layout } = this
    if (!chosen || !layout) return undefined
    return rowsOf(layout)
      .flat()
      .find(({ point }) => pointName(point) === chosen)
  }

  private readonly point = (event: PointerEvent): void => {
    const spot = this.under(event)
    this.chosen = spot && pointName(spot.point)
  }

  private readonly clicked = (event: MouseEvent): void => {
    const spot = this.under(event)
    if (!spot) return
    this.chosen = pointName(spot.point)
    this.show(spot.point)
  }

  private under({ clientX, clientY, currentTarget }: MouseEvent): Spot | undefined {
    const { left, top } = (currentTarget as HTMLElement).getBoundingClientRect()
    return this.layout && nearestSpot(this.layout, clientX - left, clientY - top)
  }

  private readonly pressed = (event: KeyboardEvent): void => {
    const { layout } = this
    const { key, ctrlKey, metaKey, altKey } = event
    if (!layout || ctrlKey || metaKey || altKey) return
    const spot = this.spot()
    const moves: Record<string, readonly [number, number]> = {
      ArrowLeft: [0, -1],
      ArrowRight: [0, 1],
      ArrowUp: [-1, 0],
      ArrowDown: [1, 0],
      Home: [0, -Infinity],
      End: [0, Infinity],
    }
    const move = moves[key]
    if ((key === 'Enter' || key === ' ') && spot) this.show(spot.point)
    else if (!move) return
    else this.go(layout, spot, move)
    // The lab's own keys move its transport.
    event.preventDefault()
    event.stopPropagation()
  }

  private go(
    layout: DiagramLayout,
    from: Spot | undefined,
    [across, along]: readonly [number, number],
  ) {
    const rows = rowsOf(layout)
    const row = from ? rows.findIndex((spots) => spots.includes(from)) : 0
    const spots = rows[(row + across + rows.length) % rows.length]!
    // Another curve is met at the same rate.
    const met = spots.findIndex(({ point }) => point.rate === from?.point.rate)
    const place = !from ? 0 : across ? met : spots.indexOf(from) + along
    const { point } = spots[Math.max(0, Math.min(spots.length - 1, place))]!
    this.chosen = pointName(point)
    const kind = costKinds.find(({ id }) => id === this.cost)!
    this.told = `${this.chosen}: ${pointWords(point, kind)}.`
  }

  private show(point: DiagramPoint): void {
    // It is there already.
    if (point.runner) return
    this.load({
      experiment: sweptExperiment(this.request, point.method, point.rate),
      label: pointName(point),
      words: `It is ${pointWords(
        point,
        costKinds.find(({ id }) => id === this.cost)!,
      )}.`,
    })
  }
}
