import { fixed, plain } from './numbers.ts'
import { roundAbove, toStep } from './round.ts'
import { ROUNDING } from '../panels/plots/quantity.ts'

/** A tick of an axis, and what is written at it. */
export interface Tick {
  readonly at: number
  readonly label: string
}

/** A stretch of numbers laid out evenly. */
export interface Axis {
  readonly from: number
  readonly to: number
  /** Where a value stands between `from` and `to`. */
  readonly at: (value: number) => number
  /** At most so many ticks, apart from one at 0. */
  readonly ticks: (most: number) => Tick[]
}

const thin = '\u2009'

/** An axis for values as they are, with a little room beyond them where `padded`. */
export function linearAxis(from: number, to: number, unit: string, padded = true): Axis {
  const room = padded ? 0.04 * (to - from) : 0
  return {
    from: from - room,
    to: to + room,
    at: (value) => value,
    ticks: (most) => linearTicks(from - room, to + room, unit, most),
  }
}

function linearTicks(from: number, to: number, unit: string, most: number): Tick[] {
  const step = roundAbove((to - from) / Math.max(1, most))
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
  const ticks: Tick[] = []
  for (let i = Math.ceil(from / step - 1e-9); i * step <= to + 1e-9 * step; i++) {
    const at = toStep(i * step, step)
    const figure = decimals > 4 || Math.abs(at) >= 1e5 ? plain(at) : fixed(at, decimals)
    ticks.push({ at, label: `${figure}${thin}${unit}` })
  }
  return ticks
}

/**
 * An axis by powers of ten for errors [m]. What is nothing but rounding stands on a line of its own at the foot, a
 * decade below the smallest error worth the name, however many decades lie between: they would be empty.
 *
 * @param smallest of the errors that are not rounding; Infinity if there are none
 * @param largest likewise; 0 if there are none
 */
export function errorAxis(smallest: number, largest: number): Axis {
  const top = largest > 0 ? Math.ceil(Math.log10(largest) + 1e-9) : 0
  const bottom = Math.min(top - 2, Math.floor(Math.log10(Math.min(smallest, 1)) + 1e-9))
  const foot = bottom - 1
  return {
    from: foot - 0.25,
    to: top,
    at: (value) => (value < ROUNDING ? foot : Math.log10(value)),
    ticks: (most) => {
      const step = [1, 3, 6, 9].find((each) => (top - bottom) / each < most - 1) ?? 12
      const ticks: Tick[] = [{ at: foot, label: 'rounding' }]
      for (let power = Math.ceil(bottom / step) * step; power <= top; power += step)
        ticks.push({ at: power, label: powerOfTen(power) })
      return ticks
    },
  }
}

const prefixes = ['', 'm', 'µ', 'n', 'p']

/** “100 mm”, “1 µm”, “10 km”. */
function powerOfTen(power: number): string {
  if (power >= 6) return `${plain(10 ** power)}${thin}m`
  if (power >= 3) return `${10 ** (power - 3)}${thin}km`
  const i = Math.ceil(-power / 3)
  const prefix = i > 0 ? prefixes[i]! : ''
  return `${Math.round(10 ** (power + 3 * Math.max(0, i)))}${thin}${prefix}m`
}
