import { roundBelow } from '../../chart/round.ts'

/** As many bars as can be told apart. */
const MOST = 40
/** So many bars between 0 and the usual frame time, more or less. */
const FINENESS = 16

/** How many frame times lie in [from, to), in seconds. */
export interface Bin {
  readonly from: number
  /** Infinity in a last bin that holds all that are longer, too. */
  readonly to: number
  readonly count: number
}

/** Frame times [s] sorted into bins of a round width, from 0 on: as many as it takes, or as can be told apart. */
export function binsOf(durations: readonly number[], median: number): Bin[] {
  // In whole units of a hundredth of a millisecond, so that a time on an edge is on the right side of it.
  const unit = 1e5
  const width = Math.max(1, Math.round(roundBelow(median / FINENESS) * unit))
  const counts: number[] = []
  for (const duration of durations) {
    const bin = Math.min(MOST - 1, Math.floor(Math.round(duration * unit) / width))
    counts[bin] = (counts[bin] ?? 0) + 1
  }
  const edge = (i: number) => (i < MOST ? (i * width) / unit : Infinity)
  return Array.from(counts, (count = 0, i) => ({ from: edge(i), to: edge(i + 1), count }))
}
