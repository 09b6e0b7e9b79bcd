import type { Box } from './geometry.ts'
import type { Palette } from '../view/palette.ts'
import type { Drawing } from '../panels/plots/curves.ts'

/** Between a label and the box [px]. */
const GAP = 6

/** Draws the grid in a box, and at each of its lines what stands there. */
export function drawAxes(
  pen: CanvasRenderingContext2D,
  { across, up }: Drawing,
  { left, top, right, bottom }: Box,
  palette: Palette,
): void {
  pen.font = `11px ${palette.sans}`
  pen.fillStyle = palette.inkSoft
  pen.strokeStyle = palette.line
  pen.lineWidth = 1
  pen.beginPath()
  pen.textAlign = 'center'
  pen.textBaseline = 'top'
  for (const { at, label } of across.ticks((right - left) / 48)) {
    const x = left + ((at - across.from) / (across.to - across.from)) * (right - left)
    pen.moveTo(crisp(x), top)
    pen.lineTo(crisp(x), bottom)
    pen.fillText(label, x, bottom + GAP)
  }
  pen.textAlign = 'right'
  pen.textBaseline = 'middle'
  for (const { at, label } of up.ticks((bottom - top) / 28)) {
    const y = bottom - ((at - up.from) / (up.to - up.from)) * (bottom - top)
    pen.moveTo(left, crisp(y))
    pen.lineTo(right, crisp(y))
    pen.fillText(label, left - GAP, y)
  }
  pen.stroke()
}

/** The nearest place where a line one pixel wide covers whole pixels of the screen. */
function crisp(at: number): number {
  const half = (Math.round(devicePixelRatio) % 2) / 2
  return (Math.floor(at * devicePixelRatio) + half) / devicePixelRatio
}
