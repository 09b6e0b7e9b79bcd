import { html, LitElement, nothing } from 'lit'
import type { PropertyValues } from 'lit'
import { count, fixed } from '../../chart/numbers.ts'
import type { LabView } from '../../lab/labView.ts'
import { summarize } from '../../lab/state/frameTimes.ts'
import type { Candidate, Unit } from '../../logs/index.ts'
import { frameClocks } from '../../physics/index.ts'
import '../../ui/quantityControl.ts'
import type { Quantity } from '../../ui/quantityControl.ts'
import { binsOf, histogram } from './histogram.ts'
import { framesBetween, logSummary, rows, stretchOf } from './logWords.ts'
import type { LogStretch } from './logWords.ts'
import { useFrames } from './useFrames.ts'

export { readInSlices } from './readInSlices.ts'

/** As many frames as the clock takes. */
const MOST = frameClocks.find((clock) => clock.id === 'recorded')!.options.durations.maxLength

/**
 * What a log says, before it is taken: its frame times in numbers and as a histogram, what else it could be read as, and
 * which part of it to take.
 *
 * - `candidates`: what it can be read as, the likeliest first
 * - `name`: of the file
 * - `lab`, `selected`: where the frames can go
 * - `tell`: told what has been done
 * - `close`: called when it is no longer wanted
 */
class LogSample extends LitElement {
  static override properties = {
    candidates: { attribute: false },
    name: {},
    lab: { attribute: false },
    selected: {},
    chosen: { state: true },
    from: { state: true },
    to: { state: true },
  }

  declare candidates: readonly Candidate[]
  declare name: string
  declare lab: LabView
  declare selected: string
  declare tell: (message: string) => void
  declare close: () => void
  declare private chosen: Candidate
  /** The part to take [s]. */
  declare private from: number
  declare private to: number
  private stretch!: LogStretch

  override createRenderRoot(): this {
    return this
  }

  override willUpdate(changed: PropertyValues): void {
    if (changed.has('candidates')) this.take(this.candidates[0]!)
  }

  override render() {
    const { chosen, name } = this
    const frames = this.frames
    const about = logSummary(frames, chosen)
    return html`<section class="sample" tabindex="-1" aria-label="${name}: ${about}">
      <p><b>${name}.</b> <span class="summary">${about}.</span></p>
      ${histogram(binsOf(frames, summarize(frames).median), `Histogram of frame times: ${about}`)}
      ${this.choices()} ${this.range(frames)} ${this.leftOut()}
      ${useFrames({
        ...{ lab: this.lab, selected: this.selected, tell: this.tell },
        whose: 'the frames of the log',
        durations: () => [...frames],
      })}
      <button type="button" class="add" @click=${this.close}>Close the log</button>
    </section>`
  }

  private get frames(): Float64Array {
    return framesBetween(this.stretch, this.from, this.to, MOST)
  }

  private get total(): number {
    // To the millisecond above, so that the last frame is in it.
    return Math.ceil(this.stretch.instants.at(-1)! * 1000) / 1000
  }

  private take(candidate: Candidate): void {
    this.chosen = candidate
    this.stretch = stretchOf(candidate.durations)
    this.from = 0
    this.to = this.total
  }

  /** Menus where more than one process, column or unit could be meant. */
  private choices() {
    const { candidates, chosen } = this
    const processes = [...new Set(candidates.map(({ process }) => process))]
    const columns = candidates.filter(({ process }) => process === chosen.process)
    const isFirst = chosen.process === processes[0]
    return html`${
      processes.length > 1
        ? html`${menu('Process', processes, chosen.process, (process) =>
              this.take(candidates.find((each) => each.process === process)!),
            )}
            <p class="small">
              The log holds ${processes.length}${isFirst ? ', and this one has the most rows' : ''}.
            </p>`
        : nothing
    }
    ${
      columns.length > 1
        ? menu(
            'Column',
            columns.map(({ column }) => column),
            chosen.column,
            (column) => this.take(columns.find((each) => each.column === column)!),
          )
        : nothing
    }
    ${
      chosen.units.length > 1
        ? menu('Unit', chosen.units, chosen.unit, (unit) => this.take(chosen.inUnit(unit as Unit)))
        : nothing
    }`
  }

  private range(frames: Float64Array) {
    const { total, from, to } = this
    const quantity = (label: string): Quantity => ({
      ...{ label, symbol: '', unit: 's', min: 0, max: total },
      slider: { from: 0, to: total, step: Number((total / 200).toPrecision(1)) },
    })
    const pick = (set: (value: number) => void, isPossible: (value: number) => boolean) => {
      return (value: unknown): string => {
        if (typeof value !== 'number') return `“${String(value)}” is not a number`
        if (!(value >= 0 && value <= total)) return `It is within 0…${total} s`
        if (!isPossible(value)) return 'The part has to begin before it ends'
        set(value)
        return ''
      }
    }
    const starts = pick(
      (value) => (this.from = value),
      (value) => value < to,
    )
    const ends = pick(
      (value) => (this.to = value),
      (value) => value > from,
    )
    const cut =
      frames.length === MOST
        ? html`<p class="small">
            The clock takes ${count(MOST)} frames at most: the first
            ${fixed(
              frames.reduce((sum, each) => sum + each, 0),
              1,
            )}
            s of this part.
          </p>`
        : nothing
    return html`<div class="quantities" .style="--rows: 2">
        <slide-quantity-control
          .quantity=${quantity('Take it from')}
          .value=${from}
          .initial=${0}
          .pick=${starts}
        ></slide-quantity-control>
        <slide-quantity-control
          .quantity=${quantity('Take it up to')}
          .value=${to}
          .initial=${total}
          .pick=${ends}
        ></slide-quantity-control>
      </div>
      ${cut}`
  }

  private leftOut() {
    const { leftOut, reasons } = this.chosen
    if (leftOut === 0) return nothing
    return html`<details class="left-out">
      <summary>${rows(leftOut)} left out</summary>
      <ul>
        ${reasons.map(({ place, reason }) => html`<li>${place} ${reason}</li>`)}
        ${leftOut > reasons.length ? html`<li>… and ${count(leftOut - reasons.length)} more</li>` : nothing}
      </ul>
    </details>`
  }
}

function menu(
  label: string,
  options: readonly string[],
  chosen: string,
  pick: (option: string) => void,
) {
  return html`<label class="choice"
    >${label}
    <select @change=${(event: Event) => pick((event.target as HTMLSelectElement).value)}>
      ${options.map(
        (option) => html`<option value=${option} .selected=${option === chosen}>${option}</option>`,
      )}
    </select>
  </label>`
}

customElements.define('slide-log-sample', LogSample)
