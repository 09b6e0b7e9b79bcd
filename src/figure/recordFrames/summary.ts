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

function sum(list: readonly number[]): number {
  return list.reduce((total, each) => total + each, 0)
}
