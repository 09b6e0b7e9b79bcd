import { html, LitElement, nothing } from 'lit'
import type { Report } from '../../../report/schema.ts'
import { aims } from './aims.ts'
import { engineErrors } from './engineErrors.ts'
import { engineTimes } from './engineTimes.ts'
import { fetchReport } from './fetchReport.ts'
import { machineLine } from './machineLine.ts'
import { stepTimes } from './stepTimes.ts'

/** What the report says that comes with the page, fetched when it is unfolded. */
export class MeasuredReport extends LitElement {
  static override properties = {
    report: { state: true },
    problem: { state: true },
    clock: { state: true },
  }

  declare private report: Report | undefined
  declare private problem: string
  /** Under which the engines' errors are shown. */
  declare private clock: string
  private asked = false

  constructor() {
    super()
    this.problem = ''
    this.clock = ''
  }

  override createRenderRoot(): this {
    return this
  }

  override render() {
    const { report, problem } = this
    return html`<details class="measured" @toggle=${this.toggled}>
      <summary>What we measured: this project beside a bare loop and physics engines</summary>
      ${problem ? html`<p role="alert">${problem}</p>` : nothing}
      ${report ? this.content(report) : nothing}
      ${!report && !problem && this.asked ? html`<p class="soft">Loading …</p>` : nothing}
    </details>`
  }

  private content(report: Report) {
    return html`${machineLine(report)} ${stepTimes(report)} ${engineTimes(report)}
    ${engineErrors(report, this.clock || report.peers.clocks[0]!, (clock) => (this.clock = clock))}
    ${aims(report)}
    ${
      report.notRun.length > 0
        ? html`<p>
            Not run: ${report.notRun.map(({ what, why }) => `${what} (${why})`).join('; ')}.
          </p>`
        : nothing
    }`
  }

  private readonly toggled = async (event: Event): Promise<void> => {
    if (this.asked || !(event.target as HTMLDetailsElement).open) return
    this.asked = true
    this.requestUpdate()
    try {
      this.report = await fetchReport()
    } catch (error) {
      this.problem = (error as Error).message
    }
  }
}
