import type { Picture } from './picture.ts'
import { endOf, rowAt } from './timeline.ts'

/**
 * All that time changes in the blocks of a picture, as numbers: at two times with the same numbers they look the same.
 * Forces are not among them.
 */
export function standingAt({ runners, exact, time }: Picture): number[] {
  const numbers = [exact(time, { s: 0, v: 0 }).s]
  for (const { trajectory, goal } of runners) {
    const row = rowAt(trajectory, time)
    const end = endOf(trajectory)
    numbers.push(
      ...[trajectory.s[row]!, trajectory.drawnS[row]!, (goal ?? trajectory).drawnS[row]!],
      end && row >= end.row ? 1 : 0,
    )
  }
  return numbers
}
