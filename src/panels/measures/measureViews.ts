import { html, LitElement, nothing } from 'lit'
import type { SceneId } from '../../physics/index.ts'
import type { Method } from '../../measure/index.ts'
import { segments } from '../../ui/segments.ts'
import type { LabView } from '../../lab/labView.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import { loadInto, loadMethod } from './loading.ts'
import type { Measured } from './loading.ts'
import './rateMapView.ts'
import './report/measuredReport.ts'
import './speedDiagram.ts'
import './spreadView.ts'

const views = [
  {
    id: 'diagram',
    label: 'Speed against error',
    about:
      'Every method, at 5 to 960 steps a second, in the lab’s scene: what a simulated second costs, and how far off the block ever is.',
  },
  {
    id: 'map',
    label: 'Frame-rate map',
    about:
      'One method at every frame rate and every value of a parameter: each dot is a whole run.',
  },
  {
    id: 'spread',
    label: 'Frame-rate spread',
    about:
      'One number for each method and scene: 0 where the frame rate leaves no trace. The paper’s own step stands at the top.',
  },
] as const

/**
 * The measures of a lab, one view at a time. They follow the lab, and what is clicked on is shown there.
 *
 * - `simulated`: what the lab shows
 * - `selected`: the index of the runner that is looked at closely
 * - `lab`: the lab
 */
class MeasureViews extends LitElement {
  static override properties = {
    simulated: { attribute: false },
    selected: { attribute: false },
    view: { state: true },
  }

  declare simulated: Simulated
  declare selected: number
  declare lab: LabView
  declare private view: (typeof views)[number]['id']

  constructor() {
    super()
    this.view = 'diagram'
  }

  override createRenderRoot(): this {
    return this
  }

  override render() {
    const { view } = this
    return html`${segments({
        label: 'What is measured',
        list: views.map(({ id, label }) => ({ id, label })),
        chosen: view,
        pick: ({ id }) => (this.view = id),
      })}
      <p class="about">${views.find(({ id }) => id === view)!.about}</p>
      ${this.chosen()}`
  }

  private chosen() {
    const { simulated, selected, view } = this
    const runner = simulated.runners[selected] ?? simulated.runners[0]!
    const { experiment } = runner.trajectory
    switch (view) {
      case 'diagram':
        return html`<slide-speed-diagram
            .experiment=${experiment}
            .runners=${simulated.visible}
            .load=${this.load}
          ></slide-speed-diagram>
          <slide-measured-report></slide-measured-report>`
      case 'map':
        return html`<slide-rate-map
          .experiment=${experiment}
          .paletteIndex=${runner.state.paletteIndex}
          .load=${this.load}
        ></slide-rate-map>`
      case 'spread':
        return html`<slide-spread-view
          .state=${simulated.state}
          .load=${this.loadMethod}
        ></slide-spread-view>`
      default:
        return nothing
    }
  }

  private readonly load = (measured: Measured): void => loadInto(this.lab, measured)

  private readonly loadMethod = (
    scene: SceneId,
    method: Method,
    label: string,
    words: string,
  ): void => loadMethod(this.lab, scene, method, { label, words })
}

customElements.define('slide-measure-views', MeasureViews)
