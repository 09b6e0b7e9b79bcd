import { html, LitElement, nothing } from 'lit'
import { onNear } from '../../ui/visibility.ts'
import type { LabView } from '../../lab/labView.ts'
import type { Simulated } from '../../lab/state/simulation.ts'

/**
 * The place of the measures in a lab: what they are made of is loaded when it comes near the window.
 *
 * - `simulated`: what the lab shows
 * - `selected`: the index of the runner that is looked at closely
 * - `lab`: the lab
 */
class LabMeasures extends LitElement {
  static override properties = {
    simulated: { attribute: false },
    selected: { attribute: false },
    loaded: { state: true },
  }

  declare simulated: Simulated
  declare selected: number
  /** Not reactive: it is the same for good. */
  declare lab: LabView
  declare private loaded: boolean
  private stopWatching = () => {}

  constructor() {
    super()
    this.loaded = false
  }

  override createRenderRoot(): this {
    return this
  }

  override connectedCallback(): void {
    super.connectedCallback()
    this.stopWatching = onNear(this, (isNear) => {
      if (isNear && !this.loaded) void this.make()
    })
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback()
    this.stopWatching()
  }

  override render() {
    const { simulated, selected, lab, loaded } = this
    return html`<section class="measures">
      <h2>Measures</h2>
      ${
        loaded
          ? html`<slide-measure-views
              .simulated=${simulated}
              .selected=${selected}
              .lab=${lab}
            ></slide-measure-views>`
          : nothing
      }
    </section>`
  }

  private async make(): Promise<void> {
    await import('./measureViews.ts')
    this.loaded = true
    this.stopWatching()
  }
}

customElements.define('slide-lab-measures', LabMeasures)
