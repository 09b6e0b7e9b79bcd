/** A block whose step of any length from the present state can be tried. */
interface Tried {
  tryStep(h: number): void
}

const MOST_TRIES = 100

/**
 * Finds where inside a step that has just been tried an event happens, and leaves the step to that instant tried. False
 * position with the Illinois correction (Dowell & Jarratt, 1971), a bisection now and then.
 *
 * @param h the length of the step tried [s]
 * @param residual how far the tried step ends before the event, negative past it
 * @returns the length of the step that ends at the event [s]
 */
export function locate(block: Tried, h: number, residual: () => number): number {
  let late = h
  let after = residual()
  let early = 0
  block.tryStep(early)
  let before = residual()
  // A step that starts at the event and comes back to it: look for an instant in between.
  while (before <= 0 && late > 0) {
    early = late / 2
    block.tryStep(early)
    before = residual()
    if (before > 0) break
    late = early
    after = before
  }
  const tolerance = Number.EPSILON * before
  let side = 0
  for (let tries = 1; ; tries++) {
    const width = late - early
    const bisect = tries % 8 === 0
    const length = early + (bisect ? width / 2 : (width * before) / (before - after))
    block.tryStep(length)
    const found = residual()
    const done = Math.abs(found) <= tolerance || width <= Number.EPSILON * late
    if (done || tries === MOST_TRIES) return length
    if (found > 0) {
      if (side > 0) after /= 2
      early = length
      before = found
      side = 1
    } else {
      if (side < 0) before /= 2
      late = length
      after = found
      side = -1
    }
  }
}
