import { html, LitElement, nothing } from 'lit'
import { integrators, stoppings } from '../../physics/index.ts'
import type { Experiment, StoppingId } from '../../physics/index.ts'
import { sweptExperiment, tolerantExperiment } from '../../measure/index.ts'
import type { SweepCurve, SweepRequest, TimedCurve } from '../../measure/index.ts'
import { raw } from '../../chart/numbers.ts'
import { menu } from '../../ui/menu.ts'
import { segments } from '../../ui/segments.ts'
import { tableFold } from '../../ui/tableFold.ts'
import '../../ui/runnerMark.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'
import { diagramAdvice, errorText, pointName, pointWords, diagramTable } from './diagramWords.ts'
import { diagramDrawing } from './diagramDrawing.ts'
import { layOutDiagram } from './diagramLayout.ts'
import type { DiagramLayout, DiagramSpot } from './diagramLayout.ts'
import { labRunners } from './labRunners.ts'
import type { LabRunner } from './labRunners.ts'
import { loadByAddress } from './loading.ts'
import type { Measured } from './loading.ts'
import { Measuring, progress } from './measuring.ts'
import { areaSize } from './pictureArea.ts'
import { costKinds } from './points.ts'
import type { CostKind, DiagramCurve, DiagramPoint } from './points.ts'
import { spotChoice, spotNamed } from './spotChoice.ts'
import { Curves, curvesAt, missing, sweepRequest } from './sweptCurves.ts'

/**
 * Speed against error: what each method costs in a scene, and the error that this buys, measured while it can be seen.
 *
 * - attribute or property `experiment`: the scene, its parameters and the duration, as JSON; its method and frames say
 *   nothing
 * - `runners`: of the lab that it stands in, to be seen among the curves
 * - `load`: called with the run that the reader wants to see; without it the page's own lab shows it
 */
class SpeedDiagram extends LitElement {
  static override properties = {
    experiment: { type: Object },
    runners: { attribute: false },
    stopping: { state: true },
    kind: { state: true },
  }

  declare experiment: Experiment
  declare runners: readonly SimulatedRunner[]
  /** Not reactive: a fresh closure is no reason to draw again. */
  load: (measured: Measured) => void = loadByAddress
  /** Where everything is that was drawn last, if anything was. */
  layout: DiagramLayout | undefined
  declare private stopping: StoppingId
  /** What a simulated second costs. */
  declare private kind: CostKind
  private readonly size = areaSize(this)
  private readonly choice = spotChoice(this)
  private readonly fold = tableFold(this)
  private readonly swept = new Curves<SweepCurve>()
  private readonly timed = new Curves<TimedCurve>()
  private readonly measuring: Measuring = new Measuring(this, (task, parts, fresh) => {
    if (task.kind === 'sweep') this.swept.take(task.request, parts as SweepCurve[], fresh)
    if (task.kind === 'timing') this.timed.take(task.request, parts as TimedCurve[], fresh)
  })

  constructor() {
    super()
    this.experiment = { scene: 'half-pipe' }
    this.stopping = 'located'
    this.kind = costKinds[0]!
    this.runners = []
  }

  override createRenderRoot(): this {
    return this
  }

  override willUpdate(): void {
    const { measuring } = this
    // What can't be timed here can still be counted.
    if (this.kind.id === 'time' && measuring.problem) {
      measuring.notice = measuring.problem
      this.kind = costKinds[0]!
    }
    measuring.want(missing(this.request, this.kind, this.swept, this.timed))
  }

  override render() {
    const { request, size, stopping, measuring, kind, choice } = this
    const curves = curvesAt(kind, this.swept, this.timed)
    const isCurrent = this.swept.areOf(request)
    const runners = labRunners(
      this.runners,
      { stopping, duration: request.experiment.duration! },
      kind.id === 'time' ? curves : undefined,
    )
    const points = runners.flatMap(({ point }) => (point && isCurrent ? [point] : []))
    this.layout =
      size.width > 0 && curves.length > 0 ? layOutDiagram(curves, size, points) : undefined
    const spot = spotNamed(this.layout, choice.chosen)
    return html`<div class="measure" ?data-busy=${measuring.busy}>
      ${this.controls()}
      ${choice.area(
        html`${this.layout ? diagramDrawing(this.layout, kind, spot) : nothing}
        ${request.experiment.duration === 0 ? html`<p class="absent">A run of 0 s costs nothing and is never wrong.</p>` : nothing}`,
      )}
      ${curveKey(curves)} ${runners.length > 0 ? ringKey(runners) : nothing}
      <p class="read-out">${this.readOut(spot)}</p>
      <output class="visually-hidden">${choice.told}</output>
      ${this.fold('speed against error', () => diagramTable(curves, points, kind))}
      ${diagramAdvice(curves, kind.label, (point) => this.show(point))}
    </div>`
  }

  private controls() {
    return html`<div class="measure-controls">
      ${segments({
        label: 'What a simulated second costs',
        list: costKinds,
        chosen: this.kind.id,
        pick: (kind) => {
          this.measuring.notice = ''
          this.kind = kind
        },
      })}
      <label class="choose">
        Stops
        ${menu({
          label: 'Stopping rule of the diagram',
          list: stoppings,
          chosen: this.stopping,
          pick: (id) => {
            this.stopping = id
            return true
          },
        })}
      </label>
      ${progress(this.measuring)}
    </div>`
  }

  private readOut(spot: DiagramSpot | undefined) {
    return spot
      ? html`<b>${pointName(spot.point)}</b>: ${this.words(spot.point)}.
          ${spot.point.runner ? nothing : html`<span class="soft">Click to see it in the lab.</span>`}`
      : html`<span class="soft"
          >Further down is better, further left is cheaper; the grey band joins the best. Dashed
          lines choose their steps, to a tolerance. Point at a mark to read it.</span
        >`
  }

  /** What a point says, in a sentence. */
  words(point: DiagramPoint): string {
    return pointWords(point, this.kind)
  }

  /** Has a point's run shown; a runner's is there already. */
  show(point: DiagramPoint): void {
    if (point.runner) return
    this.load({
      experiment: (point.by === 'rate' ? sweptExperiment : tolerantExperiment)(
        this.request,
        point.method,
        point.setting,
      ),
      label: pointName(point),
      words: `It is ${this.words(point)}.`,
    })
  }

  private get request(): SweepRequest {
    return sweepRequest(this.experiment, this.stopping)
  }
}

/** Which curve is whose, and of what order it turned out. Its room is known before the curves are. */
export function curveKey(curves: readonly DiagramCurve[]) {
  return html`<ul class="key curve-key">
    ${integrators.map(
      ({ id, label, colour }) =>
        html`<li>
          <slide-runner-mark .paletteIndex=${colour}></slide-runner-mark> ${label}
          <span class="soft"
            >${curves.find(({ method, by }) => method === id && by === 'rate')?.order}</span
          >
        </li>`,
    )}
    <li class="soft">Dashed: to tolerance, with its tries</li>
  </ul>`
}

/** Which ring is which runner's, with its error, or why it has none. */
export function ringKey(runners: readonly LabRunner[]) {
  return html`<ul class="key ring-key">
    <li class="soft">Rings: the lab’s runners</li>
    ${runners.map(
      ({ name, paletteIndex, point, why }) =>
        html`<li title=${point ? `${raw(point.error)} m` : ''}>
          <slide-runner-mark .paletteIndex=${paletteIndex}></slide-runner-mark> ${name}
          <span class="soft">${point ? errorText(point) : `no ring: ${why}`}</span>
        </li>`,
    )}
    ${
      runners.some(({ point }) => point?.runner!.apart)
        ? html`<li class="soft">
            Dashed rings: another stopping rule or time step than the curves
          </li>`
        : nothing
    }
  </ul>`
}

customElements.define('slide-speed-diagram', SpeedDiagram)
