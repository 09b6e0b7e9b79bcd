/**
 * The search for the length at which a step ends at a jump of the law, one try at a time: false position with the Illinois
 * correction (Dowell & Jarratt, 1971), a bisection now and then.
 */
export class Search {
  searching = false
  private early = 0
  private missEarly = 0
  private late = 0
  private missLate = 0
  private side = 0
  private tries = 0

  /**
   * Takes a step of length `h` that ends `miss` before the jump, negative past it, where one of no length ends `start`
   * before it. Returns the length to try next; it is found where `searching` is false after that.
   */
  next(h: number, start: number, miss: number): number {
    if (!this.searching) {
      this.searching = true
      this.early = 0
      this.missEarly = start
      this.late = h
      this.missLate = miss
      this.side = 0
      this.tries = 0
    } else if (Math.abs(miss) <= Number.EPSILON * start || this.tries === 100) {
      this.searching = false
      return h
    } else if (miss > 0) {
      if (this.side > 0) this.missLate /= 2
      this.early = h
      this.missEarly = miss
      this.side = 1
    } else {
      if (this.side < 0) this.missEarly /= 2
      this.late = h
      this.missLate = miss
      this.side = -1
    }
    const width = this.late - this.early
    this.tries++
    const length =
      this.tries % 8 === 0
        ? this.early + width / 2
        : this.early + (width * this.missEarly) / (this.missEarly - this.missLate)
    if (width <= Number.EPSILON * this.late) this.tries = 100
    return length
  }
}
