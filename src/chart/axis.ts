import { decadeAbove, decadeBelow, decadeTick } from './magnitudes.ts'
import { fixed, plain } from './numbers.ts'
import { decimalsOf, roundAbove, toStep } from './ticks.ts'

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
        return { at, label: `${number}\u202f${unit}` }
      })
    },
  }
}

/** A linear axis with short labels: no unit, no trailing zeros. It may run from a large value to a small one. */
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
 * An axis by powers of ten for errors [m]. Errors that are rounding stand on a line of their own at the foot, a
 * decade below the smallest other error: the decades between would be empty.
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
