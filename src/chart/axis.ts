import { decadeAbove, decadeBelow, decadeTick } from './magnitudes.ts'
import { fixed, plain } from './numbers.ts'

/** Numbers that people would choose for the ticks of an axis: 1, 2 or 5 times a power of ten. */

/** The largest round number that is not above a positive limit. */
export function roundBelow(limit: number): number {
  const power = 10 ** Math.floor(Math.log10(limit))
  const digit = limit / power
  // A limit that is itself round may come out a bit below itself.
  const slack = 1 + 1e-9
  return clean((digit * slack >= 5 ? 5 : digit * slack >= 2 ? 2 : 1) * power)
}

/** The smallest round number that is not below a positive limit. */
export function roundAbove(limit: number): number {
  const power = 10 ** Math.floor(Math.log10(limit))
  const digit = limit / power
  const slack = 1 - 1e-9
  return clean(
    (digit * slack <= 1 ? 1 : digit * slack <= 2 ? 2 : digit * slack <= 5 ? 5 : 10) * power,
  )
}

/** The multiple of a round step that is nearest to a value, as its shortest decimal: 0.3, not 0.30000000000000004. */
export function toStep(value: number, step: number): number {
  return clean(Math.round(value / step) * step) + 0
}

/** The decimals that the multiples of a round step need. */
export function decimalsOf(step: number): number {
  return Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
}

function clean(value: number): number {
  return Number(value.toPrecision(12))
}

/** A tick of an axis, and what is written at it. */
export interface Tick {
  /** Between the axis's `from` and `to`. */
  readonly at: number
  readonly label: string
}

/** A range of values laid out evenly, or by powers of ten. */
export interface Axis {
  readonly from: number
  readonly to: number
  /** Where a value stands between `from` and `to`. */
  readonly at: (value: number) => number
  /** At most so many ticks, apart from one at 0. */
  readonly ticks: (most: number) => Tick[]
}

/** Where the points of an axis, `from` … `to`, are drawn between two places [px]. */
export function drawnBetween({ from, to }: Pick<Axis, 'from' | 'to'>, start: number, end: number) {
  const scale = (end - start) / (to - from)
  return (at: number): number => start + (at - from) * scale
}

/** The multiples of a round step between two values, in ascending order: at most so many, apart from one at 0. */
export function roundTicks(from: number, to: number, most: number) {
  const step = roundAbove(Math.abs(to - from) / Math.max(1, most))
  const first = Math.ceil(Math.min(from, to) / step - 1e-9)
  const last = Math.floor(Math.max(from, to) / step + 1e-9)
  const length = Math.max(0, last - first + 1)
  return { step, values: Array.from({ length }, (_, i) => toStep((first + i) * step, step)) }
}

/** An axis for values as they are, with a little room beyond them where `padded`. */
export function linearAxis(from: number, to: number, unit: string, padded = true): Axis {
  const room = padded ? 0.04 * (to - from) : 0
  return {
    from: from - room,
    to: to + room,
    at: (value) => value,
    ticks: (most) => {
      const { step, values } = roundTicks(from - room, to + room, most)
      const decimals = decimalsOf(step)
      return values.map((at) => {
        const number = decimals > 4 || Math.abs(at) >= 1e5 ? plain(at) : fixed(at, decimals)
        return { at, label: `${number}\u2009${unit}` }
      })
    },
  }
}

/** The same for few words: no unit, and no idle zeros. It may run the other way, from a large value to a small one. */
export function shortAxis(from: number, to: number): Axis {
  const range = Math.abs(to - from)
  const decimals = range > 8 ? 0 : range > 0.8 ? 1 : range > 0.08 ? 2 : 3
  return {
    from,
    to,
    at: (value) => value,
    ticks: (most) =>
      roundTicks(from, to, most).values.map((at) => {
        return { at, label: fixed(at, decimals).replace(/\.0+$/, '') }
      }),
  }
}

/** Powers of ten between two places of a picture. */
export interface LogScale {
  readonly from: number
  readonly to: number
  /** Where a value is [px]. */
  readonly at: (value: number) => number
  /** The exponents of the powers of ten on it. */
  readonly decades: readonly number[]
}

/** Values from one to another by powers of ten, laid out between two places [px]. */
export function logScale(from: number, to: number, start: number, end: number): LogScale {
  const place = drawnBetween({ from: Math.log10(from), to: Math.log10(to) }, start, end)
  const first = decadeAbove(from)
  const length = Math.max(0, decadeBelow(to) - first + 1)
  return {
    from,
    to,
    at: (value) => place(Math.log10(value)),
    decades: Array.from({ length }, (_, i) => first + i),
  }
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
  const bottom = Math.min(top - 2, decadeBelow(Math.min(smallest, 1)))
  const foot = bottom - 1
  return {
    from: foot - 0.25,
    to: top,
    at: (value) => (value === 0 ? foot : Math.log10(value)),
    ticks: (most) => {
      const step = [1, 3, 6, 9].find((each) => (top - bottom) / each < most - 1) ?? 12
      const ticks: Tick[] = [{ at: foot, label: 'rounding' }]
      for (let power = Math.ceil(bottom / step) * step; power <= top; power += step)
        ticks.push({ at: power, label: decadeTick(power) })
      return ticks
    },
  }
}
