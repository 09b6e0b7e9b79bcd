import { errorAxis, linearAxis } from '../../chart/axis.ts'
import type { Axis } from '../../chart/axis.ts'
import { samplesOf } from '../../view/samples.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import type { PlotKind, PlotQuantity } from './kinds.ts'
import { thinColumns, thinPath } from './thin.ts'

/** The place in the list of curves that is the true motion's: after those of the eight looks. */
export const EXACT = 8

/** A curve as it is drawn: places on both axes, and the times they belong to [s]. */
export interface Curve {
  /** Of its runner, or EXACT. */
  readonly paletteIndex: number
  readonly index: number
  readonly x: readonly number[]
  readonly y: readonly number[]
  readonly time: readonly number[]
}

/** All that a plot draws. */
export interface PlotDrawing {
  readonly across: Axis
  readonly up: Axis
  readonly curves: readonly Curve[]
  /** What a frame shows stays until the next: curves over time go in steps. */
  readonly stepped: boolean
}

/**
 * What a plot of so many pixels draws of a simulation: every visible runner's values at its own frames, as many of them
 * as the pixels can show, and the true motion.
 */
export function drawingOf(
  kind: PlotKind,
  simulated: Simulated,
  width: number,
  height: number,
): PlotDrawing {
  const { visible, runners } = simulated
  const { over, of } = kind
  const across = over ? axisOf(over, simulated) : timeAxis(simulated)
  const up = axisOf(of, simulated)
  const column = (across.to - across.from) / width
  const row = (up.to - up.from) / height
  const thinned: Thinned = over
    ? (x, y) => thinPath(x, y, column, row)
    : (x, y) => thinColumns(x, y, column)
  const curves: Curve[] = visible.map((runner) => {
    const { trajectory } = runner
    const x = over ? over.values(trajectory) : trajectory.time
    const y = of.values(trajectory)
    const rows = thinned(x, y)
    return {
      paletteIndex: runner.state.paletteIndex,
      index: runners.indexOf(runner),
      x: rows.map((row) => across.at(x[row]!)),
      y: rows.map((row) => up.at(y[row]!)),
      time: rows.map((row) => trajectory.time[row]!),
    }
  })
  if (of.ofExact && !kind.isExactHidden) curves.push(trueCurve(kind, simulated, thinned))
  return { across, up, curves, stepped: !over }
}

/** The rows of a curve that its plot can show. */
type Thinned = (x: Float64Array, y: Float64Array) => number[]

/** The true motion. What was not followed swing by swing shows how far it goes, over time, and nothing else. */
function trueCurve({ over, of }: PlotKind, simulated: Simulated, thinned: Thinned): Curve {
  const samples = samplesOf(simulated.exact, simulated.state.duration)
  const time = over ? samples.time.subarray(0, samples.followed + 1) : samples.time
  const values = ({ ofExact }: PlotQuantity) =>
    time.map((_, row) => ofExact!({ s: samples.s[row]!, v: samples.v[row]! }, simulated))
  const x = over ? values(over) : time
  const y = values(of)
  const rows = thinned(x, y)
  const picked = (from: Float64Array) => rows.map((row) => from[row]!)
  return { paletteIndex: EXACT, index: -1, x: picked(x), y: picked(y), time: picked(time) }
}

/** The largest error that an axis shows [m]. */
const LARGEST = 1e6

/** The axis on which a quantity of all visible runners has room. */
function axisOf(quantity: PlotQuantity, simulated: Simulated): Axis {
  return quantity.logarithmic ? logarithmic(quantity, simulated) : linear(quantity, simulated)
}

/** The axis of a plot over time. */
function timeAxis({ state }: Simulated): Axis {
  return linearAxis(0, state.duration || 1, 's', false)
}

/**
 * All of the true motion, and the runners as far as they stay within reach of it: one that diverges would press
 * everything else into a line.
 */
function linear(quantity: PlotQuantity, simulated: Simulated): Axis {
  const { exact, visible, state } = simulated
  let from = Infinity
  let to = -Infinity
  const { s, v } = samplesOf(exact, state.duration)
  for (let row = 0; row < s.length; row++) {
    const value = quantity.ofExact!({ s: s[row]!, v: v[row]! }, simulated)
    from = Math.min(from, value)
    to = Math.max(to, value)
  }
  if (quantity.fromZero) from = Math.min(0, from)
  const reach = Math.max(quantity.unit === 'J' ? liveliest(simulated) : to - from, quantity.least)
  const [low, high] = [from - reach, to + reach]
  for (const { trajectory } of visible) {
    for (const value of quantity.values(trajectory)) {
      if (value < from) from = Math.max(value, low)
      else if (value > to) to = Math.min(value, high)
    }
  }
  const lack = Math.max(0, quantity.least - (to - from)) / 2
  return linearAxis(from - lack, to + lack, quantity.unit)
}

/** The largest kinetic energy of the true motion [J]. */
function liveliest({ exact, state }: Simulated): number {
  const fastest = samplesOf(exact, state.duration).v.reduce(
    (most, v) => Math.max(most, Math.abs(v)),
    0,
  )
  return 0.5 * state.parameters.mass! * fastest * fastest
}

function logarithmic(quantity: PlotQuantity, { visible }: Simulated): Axis {
  let smallest = Infinity
  let largest = 0
  for (const { trajectory } of visible) {
    for (const value of quantity.values(trajectory)) {
      if (!(value > 0)) continue
      if (value < smallest) smallest = value
      if (value > largest) largest = value
    }
  }
  return errorAxis(smallest, Math.min(largest, LARGEST))
}
