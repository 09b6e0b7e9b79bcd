import { html, nothing } from 'lit'
import { raw, seconds } from '../../chart/numbers.ts'
import { rowAt } from '../../view/timeline.ts'
import '../../ui/runnerMark.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import { EXACT } from './curves.ts'
import type { PlotKind } from './kinds.ts'

/** What a runner, or the exact block, shows in a plot at a time. */
export interface PlotReading {
  readonly name: string
  /** Of its runner, or EXACT. */
  readonly paletteIndex: number
  /** Across and up. */
  readonly x: number
  readonly y: number
  readonly text: string
  /** Of the frame that shows it [s]. */
  readonly time: number
}

/** The values of every visible runner at the last of its frames by then, and the exact ones of that very time [s]. */
export function readingsAt(kind: PlotKind, simulated: Simulated, time: number): PlotReading[] {
  const { exact, visible } = simulated
  const { over, of } = kind
  const readings = visible.map(({ name, trajectory, state: { paletteIndex } }): PlotReading => {
    const row = rowAt(trajectory, time)
    const frame = trajectory.time[row]!
    const x = over ? over.values(trajectory)[row]! : frame
    return reading(kind, name, paletteIndex, x, of.values(trajectory)[row]!, frame)
  })
  if (!of.ofExact || kind.isExactHidden) return readings
  const state = exact(time, { s: 0, v: 0 })
  const x = over ? over.ofExact!(state, simulated) : time
  return [...readings, reading(kind, 'exact', EXACT, x, of.ofExact(state, simulated), time)]
}

/** The readings in a sentence. */
export function spoken(
  { title }: PlotKind,
  readings: readonly PlotReading[],
  time: number,
): string {
  const values = readings.map(({ name, text }) => `${name} ${text}`)
  return `${title} at ${seconds(time)}: ${values.join(', ')}.`
}

/** A reading with every digit, and the time of the frame that shows it. */
export function inFull({ over, of }: PlotKind, { name, x, y, time }: PlotReading): string {
  const numbers = [...(over ? [`${raw(x)} ${over.unit}`] : []), `${raw(y)} ${of.unit}`]
  return `${name}: ${numbers.join(', ')}, at t = ${raw(time)} s`
}

function reading(
  { over, of }: PlotKind,
  name: string,
  paletteIndex: number,
  x: number,
  y: number,
  time: number,
): PlotReading {
  return {
    ...{ name, paletteIndex, x, y, time },
    // Only when it is to be read: cursors are drawn more often.
    get text() {
      return over ? `${over.text(x)}, ${of.text(y)}` : of.text(y)
    },
  }
}

/**
 * What each visible runner shows at the cursor. Each has its place, whatever stands there: nothing moves when values come
 * and go.
 */
export function plotValues(
  kind: PlotKind,
  { visible }: Simulated,
  readings: readonly PlotReading[],
  pointed: (event: PointerEvent) => void,
) {
  const rows = [
    ...visible.map(({ state, name }) => ({ paletteIndex: state.paletteIndex, name })),
    ...(kind.of.ofExact && !kind.isExactHidden ? [{ paletteIndex: EXACT, name: 'exact' }] : []),
  ]
  return html`<ul class="values" data-pair=${kind.over ? '' : nothing} @pointerover=${pointed}>
    ${rows.map(({ paletteIndex, name }, i) => {
      const reading = readings[i]
      return html`<li data-index=${i}>
        ${
          paletteIndex === EXACT
            ? html`<span class="dash" aria-hidden="true"></span>`
            : html`<slide-runner-mark .paletteIndex=${paletteIndex}></slide-runner-mark>`
        }<span class="visually-hidden">${name}</span>
        <span class="value">${reading?.text ?? '–'}</span>
      </li>`
    })}
  </ul>`
}
