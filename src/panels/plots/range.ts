import { errorAxis, linearAxis } from '../../chart/axis.ts'
import type { Axis } from '../../chart/axis.ts'
import { samplesOf } from '../../view/samples.ts'
import type { Simulated } from '../../lab/state/simulation.ts'
import type { PlotQuantity } from './quantity.ts'

/** Errors above this are no longer a matter of more or less [m]. */
const LARGEST = 1e6

/** The axis on which a quantity of all visible runners has room. */
export function axisOf(quantity: PlotQuantity, simulated: Simulated): Axis {
  return quantity.logarithmic ? logarithmic(quantity, simulated) : linear(quantity, simulated)
}

/** The axis of a plot over time. */
export function timeAxis({ state }: Simulated): Axis {
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
    const value = quantity.ofExact!({ s: s[row]!, v: v[row]! })
    from = Math.min(from, value)
    to = Math.max(to, value)
  }
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
