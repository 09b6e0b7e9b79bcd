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

export function summarize(durations: readonly number[]): Summary {
  const sorted = [...durations].sort((a, b) => a - b)
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

/** The same in a sentence. */
export function summaryText(durations: readonly number[]): string {
  const { frames, total, median, most, longest, rate } = summarize(durations)
  const ms = (seconds: number) => `${fixed(seconds * 1000, 1)} ms`
  return `${frames} frames in ${fixed(total, 1)} s, about ${Math.round(rate)} Hz: median ${ms(median)}, 99 % within ${ms(most)}, longest ${ms(longest)}.`
}

function sum(list: readonly number[]): number {
  return list.reduce((total, each) => total + each, 0)
}
