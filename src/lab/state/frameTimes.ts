import { fixed } from '../../chart/numbers.ts'

/** As many as an address has room for: five seconds at 300 frames a second. */
const MOST = 1500
/** Ticks of 0.1 ms in a second: browsers tell time no finer to a page that is not trusted with more. */
const TICKS = 10_000
/** The longest frame that the clock takes [s]. */
const LONGEST = 60

/**
 * The frame times between timestamps [ms], in seconds and whole tenths of a millisecond. It is the instants that are
 * rounded, so that the times add up to what really passed. Two frames at one instant are one.
 */
export function durationsOf(timestamps: readonly number[]): number[] {
  const ticks = timestamps.map((each) => Math.round((each / 1000) * TICKS))
  return ticks
    .map((tick, i) => tick - (ticks[i - 1] ?? tick))
    .filter((length) => length > 0)
    .slice(0, MOST)
    .map((length) => Math.min(length / TICKS, LONGEST))
}

/** What browsers coarsen their clocks to, against pages that measure too much [ms], and what can't be told then. */
const coarse: readonly (readonly [number, string])[] = [
  [
    100,
    'All times are multiples of 100 ms: the browser has coarsened its clock, and how long the frames were can’t be told.',
  ],
  [
    1000 / 60,
    'All times are multiples of 16.7 ms: either every frame took whole refreshes of a 60 Hz display, or the browser has coarsened its clock. The recording can’t tell.',
  ],
  [
    1,
    'All times are multiples of 1 ms: the browser has coarsened its clock, and differences below 1 ms can’t be told.',
  ],
]
/** Far fewer may be multiples by chance. */
const FEWEST = 10

/** What can't be told from timestamps [ms] because the clock was coarsened; empty where it was not. */
export function coarseClock(timestamps: readonly number[]): string {
  if (timestamps.length < FEWEST) return ''
  const isMultiple = (unit: number) => (timestamp: number) => {
    const units = (timestamp - timestamps[0]!) / unit
    // Timestamps have a few digits.
    return Math.abs(units - Math.round(units)) * unit < 0.02
  }
  return coarse.find(([unit]) => timestamps.every(isMultiple(unit)))?.[1] ?? ''
}

/** What a list of frame times is like; times in seconds. */
export interface Summary {
  readonly frames: number
  readonly total: number
  readonly median: number
  /** All but one in a hundred are no longer. */
  readonly most: number
  readonly longest: number
  /** The display's refresh rate as far as it can be told: frames in a second, without those that came late [Hz]. */
  readonly rate: number
}

export function summarize(durations: Iterable<number>): Summary {
  const sorted = Float64Array.from(durations).sort()
  const quantile = (part: number) => sorted[Math.max(0, Math.ceil(part * sorted.length) - 1)]!
  const median = quantile(0.5)
  const usual = sorted.filter((each) => each > 0.5 * median && each < 1.5 * median)
  return {
    frames: sorted.length,
    total: sum(sorted),
    median,
    most: quantile(0.99),
    longest: quantile(1),
    rate: usual.length / sum(usual),
  }
}

/** Lists that a lab keeps are said again at every change of anything else. */
const texts = new WeakMap<readonly number[], string>()

/** The same in a sentence. */
export function summaryText(durations: readonly number[]): string {
  const text = texts.get(durations) ?? textOf(durations)
  texts.set(durations, text)
  return text
}

function textOf(durations: readonly number[]): string {
  const { frames, total, median, most, longest, rate } = summarize(durations)
  const ms = (seconds: number) => `${fixed(seconds * 1000, 1)} ms`
  return `${frames} frames in ${fixed(total, 1)} s, about ${Math.round(rate)} Hz: median ${ms(median)}, 99 % within ${ms(most)}, longest ${ms(longest)}.`
}

function sum(list: Float64Array): number {
  return list.reduce((total, each) => total + each, 0)
}
