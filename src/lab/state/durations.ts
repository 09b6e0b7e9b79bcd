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
