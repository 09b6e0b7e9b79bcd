/**
 * A running sum with one rounding error, however many terms it has: the part that each addition would
 * round away is kept beside it (Møller, Knuth: two-sum). Times that are sums of durations are
 * computed with it, so that a clock does not drift over millions of frames.
 */
export class ExactSum {
  private high = -0
  private low = -0

  /** The sum so far, rounded once. */
  get value(): number {
    return this.high + this.low
  }

  add(term: number): void {
    const sum = this.high + term
    const added = sum - this.high
    this.low += this.high - (sum - added) + (term - added)
    this.high = sum
  }
}
