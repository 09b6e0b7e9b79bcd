import { html, LitElement, nothing } from 'lit'
import { integrators, traceFrame } from '../../physics/index.ts'
import type { Experiment, Integrator, PolicyStep, ResolvedExperiment } from '../../physics/index.ts'
import { endOf, rowAt } from '../../view/timeline.ts'
import { icon } from '../../ui/icons.ts'
import type { IconName } from '../../ui/icons.ts'
import '../../ui/runnerMark.ts'
import { segments } from '../../ui/segments.ts'
import type { LabView } from '../../lab/labView.ts'
import { atNow } from '../../lab/playback/atNow.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'
import { saidHtml, say } from './said.ts'
import { stepHtml } from './stepHtml.ts'
import { frameLength, policyWords } from './stepWords.ts'
import { partName, triesIn, tryWords } from './tries.ts'
import type { Try } from './tries.ts'

/** While it plays, so much time passes before the next frame is written out [ms]: replaying a run takes time. */
const PAUSE = 250

/** A frame of a run, and the steps inside it as they ran. */
interface Shown {
  readonly runner: SimulatedRunner
  readonly row: number
  readonly steps: readonly PolicyStep[]
}

/** The step of the selected runner that led to what is on the screen, written out. */
export function stepInspector(lab: LabView) {
  const { simulated, selected, playback } = lab
  const runner = simulated.runners[selected]!
  return html`<slide-step-inspector
    .lab=${lab}
    .runner=${runner}
    .row=${atNow(playback, (time) => rowAt(runner.trajectory, time))}
    .playing=${playback.playing}
  ></slide-step-inspector>`
}

/**
 * A step written out: formula, numbers, result. The run is played again for it, so nothing is done while it is closed.
 *
 * - `lab`: what it belongs to
 * - `runner`, `row`: the run, and the row of it that the frame ends at
 * - `playing`: the row changes all the time
 */
class StepInspector extends LitElement {
  static override properties = {
    lab: { attribute: false },
    runner: { attribute: false },
    row: { attribute: false },
    playing: { attribute: false },
    open: { state: true },
    chosen: { state: true },
  }

  declare lab: LabView
  declare runner: SimulatedRunner
  declare row: number
  declare playing: boolean
  declare private open: boolean
  /** The step looked at; none: the one in which something happened, or the first. */
  declare private chosen: number | undefined
  private shown: Shown | undefined
  private writtenAt = -Infinity

  constructor() {
    super()
    this.open = false
  }

  override createRenderRoot(): this {
    return this
  }

  override willUpdate(): void {
    const { runner, row, shown } = this
    const now = performance.now()
    if (!this.open || (this.playing && now - this.writtenAt < PAUSE)) return
    if (shown?.row !== row || shown.runner.trajectory !== runner.trajectory) {
      const steps = row > 0 ? traceFrame(runner.trajectory.experiment as Experiment, row) : []
      this.shown = { runner, row, steps }
      this.chosen = undefined
      this.writtenAt = now
    }
  }

  override render() {
    const toggled = (event: Event) => {
      this.open = (event.target as HTMLDetailsElement).open
    }
    return html`<details class="inspector" @toggle=${toggled}>
      <summary><h2>Inside this step</h2></summary>
      ${this.open && this.shown ? this.body(this.shown) : nothing}
    </details>`
  }

  private body({ runner, row, steps }: Shown) {
    const { time, frames } = runner.trajectory
    const seek = (to: number) => this.lab.playback.seek(time[to]!)
    const end = endOf(runner.trajectory)
    return html`
      <p class="whose">
        <slide-runner-mark .paletteIndex=${runner.state.paletteIndex}></slide-runner-mark>
        ${runner.name}
      </p>
      ${stepper({ what: 'frame', from: 1, to: frames, at: row, go: seek })}
      ${
        end && end.row !== row
          ? html`<button type="button" class="there" @click=${() => seek(end.row)}>
              ${{ 'at-rest': 'Where it stopped', 'left-the-track': 'Where it left', diverged: runner.trajectory.abandoned ? 'Where it gave up' : 'Where it blew up' }[end.kind]}
            </button>`
          : nothing
      }
      ${
        row === 0
          ? html`<p>
              ${saidHtml(say`Nothing has been stepped yet: the first frame ends at ${time[1]!} s.`)}
            </p>`
          : html`
              <p>
                ${saidHtml(say`The frame begins at ${time[row - 1]!} s and lasts ${frameLength(runner.trajectory, row)} s.`)}
                ${saidHtml(policyWords(runner.trajectory, row, steps))}
              </p>
              ${this.step({ runner, row, steps })}
            `
      }
    `
  }

  private step({ runner, row, steps }: Shown) {
    const { experiment, outcome, stateTime } = runner.trajectory
    if (steps.length === 0) {
      const rests = outcome.kind === 'at-rest' && outcome.time <= stateTime[row]!
      return html`<p>
        ${saidHtml(
          rests
            ? say`Nothing to do: at rest since ${outcome.time} s.`
            : say`No step is due in this frame: what is shown lies between steps.`,
        )}
      </p>`
    }
    const event = steps.findIndex((step) => !step.takenBack && hasEvent(step))
    const at = this.chosen ?? Math.max(0, event)
    const go = (to: number) => {
      this.chosen = to
    }
    const tries = triesIn(steps)
    const which =
      tries.length > 0
        ? this.tries(tries, at, go, experiment)
        : stepper({ what: 'step', from: 0, to: steps.length - 1, at, go })
    return html`
      ${
        steps.length > 1
          ? html`${which}
            ${
              event >= 0 && event !== at
                ? html`<button type="button" class="there" @click=${() => go(event)}>
                    Where something happened
                  </button>`
                : nothing
            }`
          : nothing
      }
      <div class="step">${stepHtml(steps[at]!, experiment)}</div>
    `
  }

  /** The try that a step belongs to, what came of it, and the steps that it took. */
  private tries(
    tries: readonly Try[],
    at: number,
    go: (to: number) => void,
    { integrator }: ResolvedExperiment,
  ) {
    const index = tries.filter(({ first }) => first <= at).length - 1
    const shown = tries[index]!
    const { order, orderWithSpeed }: Integrator = integrators.find(({ id }) => id === integrator)!
    const said = tryWords(shown, tries[index + 1], Math.min(order, orderWithSpeed))
    const seek = (to: number) => go(tries[to]!.first)
    const parts = shown.steps.map((_, i) => ({ id: String(i), label: partName(shown, i) }))
    return html`${stepper({ what: 'try', from: 0, to: tries.length - 1, at: index, go: seek })}
      <p class="tried">${said.map((each) => html`${saidHtml(each)} `)}</p>
      ${segments({
        label: 'Steps of the try',
        list: parts,
        chosen: String(at - shown.first),
        pick: ({ id }) => go(shown.first + Number(id)),
      })}`
  }
}

/** Whether something other than sliding on happened in a step. */
function hasEvent({ stretches, standings, outcome, to }: PolicyStep): boolean {
  const kept = stretches[stretches.length - 1]?.tries.slice(-1)[0]
  return (
    outcome !== 'moving' ||
    standings.length > 0 ||
    stretches.some(({ ends }) => ends) ||
    // The clamp has set it.
    kept?.to.v !== to.v
  )
}

interface StepperOptions {
  /** What is stepped through, in the singular. */
  readonly what: string
  /** The first and the last that there is. */
  readonly from: number
  readonly to: number
  readonly at: number
  readonly go: (to: number) => void
}

/** “Step 3 of 6” between buttons to the first, the one before, the next and the last. */
function stepper({ what, from, to, at, go }: StepperOptions) {
  const button = (name: IconName, label: string, there: number) => {
    const isOff = there < from || there > to || there === at
    // aria-disabled, since `disabled` would take the focus away.
    return html`<button
      type="button"
      title=${label}
      aria-label="${label}, inside this step"
      aria-disabled=${isOff}
      @click=${() => isOff || go(there)}
    >
      ${icon(name)}
    </button>`
  }
  const name = what[0]!.toUpperCase() + what.slice(1)
  return html`<div class="stepper" role="group" aria-label="${name}s">
    ${button('start', `First ${what}`, from)} ${button('back', `Previous ${what}`, at - 1)}
    <span>${name} ${at - from + 1} of ${to - from + 1}</span>
    ${button('on', `Next ${what}`, at + 1)} ${button('end', `Last ${what}`, to)}
  </div>`
}

customElements.define('slide-step-inspector', StepInspector)
