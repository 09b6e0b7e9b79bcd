import { html, LitElement, nothing } from 'lit'
import type { Report } from '../../../report/schema/index.ts'
import { plain } from '../../../chart/numbers.ts'
import { engineErrors, engineTimes, frameTimes } from './tables.ts'
import { fetchReport } from './fetchReport.ts'

/** What the report says that comes with the page, fetched when it is unfolded. */
class MeasuredReport extends LitElement {
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
      <summary>Measurements: this project beside physics engines and handwritten loops</summary>
      ${problem ? html`<p role="alert">${problem}</p>` : nothing}
      ${report ? this.content(report) : nothing}
      ${!report && !problem && this.asked ? html`<p class="soft">Loading …</p>` : nothing}
    </details>`
  }

  private content(report: Report) {
    return html`${machineLine(report)} ${engineTimes(report)} ${frameTimes(report)}
    ${engineErrors(report, this.clock || report.engineTests.clocks[0]!, (clock) => (this.clock = clock))}
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

/** Where and when it was measured. */
function machineLine({ machine }: Report) {
  const { date, processor, cores, system, node, rounds, quick } = machine
  const day = new Date(date).toLocaleDateString('en', {
    year: 'numeric',
    month: 'long',
    day: 'numeric',
    timeZone: 'UTC',
  })
  return html`<p class="soft">
    Measured on ${day}: ${processor}, ${cores} cores, ${system}, Node ${node}; each time is the
    median of ${rounds} interleaved
    rounds.${quick ? ' A quick look with few and short rounds.' : ''}
  </p>`
}

/** What the project asks of itself, met or not. */
function aims({ targets }: Report) {
  return html`<div class="scroll" tabindex="0" role="region" aria-label="Targets, table">
    <table>
      <caption>
        What this project asks of itself
      </caption>
      <thead>
        <tr>
          <th scope="col">Target</th>
          <th scope="col">Asked for</th>
          <th scope="col">Measured</th>
          <th scope="col">Result</th>
          <th scope="col" class="prose">Where</th>
        </tr>
      </thead>
      <tbody>
        ${targets.map(
          ({ label, sense, limit, figure, met, from }) =>
            html`<tr>
              <th scope="row">${label}</th>
              <td>${sense} ${plain(limit)}</td>
              <td>${plain(figure)}</td>
              <td>${met ? 'met' : 'missed'}</td>
              <td class="prose">${from}</td>
            </tr>`,
        )}
      </tbody>
    </table>
  </div>`
}

customElements.define('slide-measured-report', MeasuredReport)
