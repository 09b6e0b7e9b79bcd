import type { Box, Point } from '../../chart/geometry.ts'
import { markPath } from '../../view/marks.ts'

/** Between two marks on a curve [px]. */
const GAP = 30

/** On a curve that runs round and round. */
const MOST = 24

/** Draws marks on frames of a runner's curve, far enough from each other to be told apart; `radius` in pixels. */
export function drawMarks(
  pen: CanvasRenderingContext2D,
  look: number,
  spots: readonly Point[],
  { box, stepped, radius }: { box: Box; stepped: boolean; radius: number },
): void {
  const { left, top, right, bottom } = box
  const far = (i: number, j: number) => {
    const dx = spots[i]!.x - spots[j]!.x
    return stepped ? dx : Math.hypot(dx, spots[i]!.y - spots[j]!.y)
  }
  const seen = ({ x, y }: Point) =>
    x >= left - 1 && x <= right + 1 && y >= top - 1 && y <= bottom + 1
  let length = 0
  spots.forEach((spot, i) => {
    if (i > 0 && seen(spot)) length += Math.min(far(i, i - 1), right - left)
  })
  const gap = Math.max(GAP, length / MOST)
  // Not all at the same places, so that marks of curves that lie on each other are seen.
  let due = (gap * (look % 4)) / 4
  let last = 0
  spots.forEach((spot, i) => {
    if (far(i, last) < due) return
    last = i
    due = gap
    if (seen(spot)) pen.fill(markPath(look, spot.x, spot.y, radius))
  })
}
