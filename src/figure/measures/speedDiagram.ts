import { html, LitElement, nothing } from 'lit'
import { integrators, stoppings } from '../../physics/index.ts'
import type { Experiment, Integrator, StoppingId } from '../../physics/index.ts'
import { sweepMethods, sweepRates, sweptExperiment } from '../../measure/index.ts'
import type { SweepCurve, SweepRequest, TimedCurve } from '../../measure/index.ts'
import { metres, plain } from '../../view/numbers.ts'
import { menu } from '../menu.ts'
import { costKinds } from './costs.ts'
import { diagramDrawing } from './diagramDrawing.ts'
import { layOut, nearestSpot } from './diagramLayout.ts'
import type { DiagramLayout, Spot } from './diagramLayout.ts'
import { diagramTable } from './diagramTable.ts'
import { advice, leastError, pointWords, rateText } from './diagramWords.ts'
import { loadByAddress } from './loading.ts'
import type { Measured } from './loading.ts'
import { Measuring } from './measuring.ts'
import { diagramCurves } from './points.ts'
import type { DiagramCurve, DiagramPoint } from './points.ts'
import { progress } from './progress.ts'
import { sharedExperiment } from './sharedExperiment.ts'
import type { Part, Task } from './task.ts'

/**
 * Speed against error: what each method costs in a scene, and the error that this buys, measured while it can be seen.
 *
 * - attribute or property `experiment`: the scene, its parameters and the duration, as JSON; its method and frames say
 *   nothing
 * - `load`: called with the run that the reader wants to see; without it the page's own lab shows it
 */
export class SpeedDiagram extends LitElement {
  static override properties = {
    experiment: { type: Object },
    stopping: { state: true },
    cost: { state: true },
    chosen: { state: true },
    told: { state: true },
    listed: { state: true },
    width: { state: true },
  }

  declare experiment: Experiment
  /** Not reactive: a fresh closure is no reason to draw again. */
  load: (measured: Measured) => void = loadByAddress
  declare private stopping: StoppingId
  declare private cost: 'evaluations' | 'time'
  /** The point that is read, by its method and its place in it. */
  declare private chosen: { method: string; rate: number } | undefined
  /** The same in words, for those who go there by keys. */
  declare private told: string
  declare private listed: boolean
  declare private width: number
  private readonly sizes = new ResizeObserver(([entry]) => {
    this.width = Math.round(entry!.contentRect.width)
  })
  private sweptKey = ''
  private swept = new Map<string, SweepCurve>()
  private timedKey = ''
  private timed = new Map<string, TimedCurve>()
  private layout: DiagramLayout | undefined
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
    const whole = this.sweptKey === key && this.swept.size === request.methods.length
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
    const { request, width, cost, stopping, measuring } = this
    const kind = costKinds.find(({ id }) => id === cost)!
    const { curves } = this
    const height = width < 480 ? 360 : 430
    this.layout = width > 0 && curves.length > 0 ? layOut(curves, width, height) : undefined
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
        .style="height: ${height}px"
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
      ${this.layout && !this.layout.named ? this.key(curves) : nothing}
      <p class="read-out">
        ${
          spot
            ? html`<b>${this.nameOf(spot.point)}</b> at ${rateText(spot.point.rate)}:
                ${pointWords(spot.point, kind)}.
                <span class="soft">Click to see it in the lab.</span>`
            : html`<span class="soft"
                >Further down is better, further left is cheaper; the grey band joins the best.
                Point at a mark to read it.</span
              >`
        }
      </p>
      <output class="visually-hidden">${this.told}</output>
      ${this.advice(curves, kind.label)}
      <details
        @toggle=${(event: Event) => (this.listed = (event.target as HTMLDetailsElement).open)}
      >
        <summary>As a table<span class="visually-hidden">: speed against error</span></summary>
        ${this.listed ? diagramTable(curves, kind) : nothing}
      </details>
    </div>`
  }

  private key(curves: readonly DiagramCurve[]) {
    return html`<ul class="key">
      ${curves.map(
        ({ look, label, order }) =>
          html`<li>
            <runner-mark .look=${look}></runner-mark> ${label} <span class="soft">${order}</span>
          </li>`,
      )}
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
                ${this.nameOf(point)} at ${rateText(point.rate)}</button
              >.
            </li>`,
        )}
      </ul>
      ${
        found.length > 0 && least > 1e-9
          ? html`<p class="soft">
              Nothing here comes nearer than ${metres(Number(least.toPrecision(2)))} with up to
              ${plain(sweepRates.at(-1)!)} steps a second.
            </p>`
          : nothing
      }
    </div>`
  }

  private nameOf({ method }: DiagramPoint): string {
    return this.integrator(method).label
  }

  private integrator(id: string): Integrator {
    return integrators.find((each) => each.id === id)!
  }

  private spot(): Spot | undefined {
    const { chosen, layout } = this
    if (!chosen || !layout) return undefined
    const drawn = layout.drawn.find(({ curve }) => curve.method === chosen.method)
    return drawn?.spots.find(({ point }) => point.rate === chosen.rate)
  }

  private readonly point = (event: PointerEvent): void => {
    const spot = this.under(event)
    const { method, rate } = this.chosen ?? {}
    if (spot?.point.method === method && spot?.point.rate === rate) return
    this.chosen = spot && { method: spot.point.method, rate: spot.point.rate }
  }

  private readonly clicked = (event: MouseEvent): void => {
    const spot = this.under(event)
    if (!spot) return
    this.chosen = { method: spot.point.method, rate: spot.point.rate }
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
    { drawn }: DiagramLayout,
    from: Spot | undefined,
    [across, along]: readonly [number, number],
  ) {
    const row = drawn.findIndex(({ curve }) => curve.method === from?.point.method)
    const next = from ? (row + across + drawn.length) % drawn.length : 0
    const { points } = drawn[next]!.curve
    const place = from ? points.findIndex(({ rate }) => rate === from.point.rate) + along : 0
    const point = points[Math.max(0, Math.min(points.length - 1, place))]!
    this.chosen = { method: point.method, rate: point.rate }
    const kind = costKinds.find(({ id }) => id === this.cost)!
    this.told = `${this.nameOf(point)} at ${rateText(point.rate)}: ${pointWords(point, kind)}.`
  }

  private show(point: DiagramPoint): void {
    const kind = costKinds[0]!
    const label = `${this.nameOf(point)} at ${rateText(point.rate)}`
    this.load({
      experiment: sweptExperiment(this.request, point.method, point.rate),
      label,
      words: `It is ${pointWords(point, costKinds.find(({ id }) => id === this.cost) ?? kind)}.`,
    })
  }
}
