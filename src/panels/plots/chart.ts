import { clamp } from '../../chart/geometry.ts'
import type { Box, Point } from '../../chart/geometry.ts'
import type { Palette } from '../../view/palette.ts'
import { drawAxes } from '../../chart/axes.ts'
import { boxOf, clip } from './box.ts'
import { drawMarks } from './curveMarks.ts'
import { EXACT } from './curves.ts'
import type { Curve, Drawing } from './curves.ts'
import { cleared } from '../../chart/pen.ts'

/** How a chart is drawn. */
export interface ChartLook {
  readonly palette: Palette
  /** The index of the runner whose curve is drawn stronger. */
  readonly selected: number
  /** [px] */
  readonly width: number
  readonly height: number
}

/** Draws the axes and all curves, each runner's with its marks. */
export function drawChart(canvas: HTMLCanvasElement, drawing: Drawing, look: ChartLook): void {
  const { palette, selected, width, height } = look
  const pen = cleared(canvas, width, height)
  const box = boxOf(width, height)
  drawAxes(pen, drawing, box, palette)
  pen.lineJoin = 'round'
  for (const curve of drawing.curves) {
    const isExact = curve.look === EXACT
    const isSelected = curve.index === selected
    const spots = spotsOf(curve, drawing, box)
    const colour = isExact ? palette.ink : palette.runners[curve.look]!.fill
    pen.save()
    clip(pen, box, 1)
    pen.strokeStyle = colour
    pen.lineWidth = isSelected ? 2.25 : 1.4
    if (isExact) pen.setLineDash([5, 4])
    // So many swings that they make an area: what is below is to be seen.
    if (isExact && spots.length > width) pen.globalAlpha = 0.35
    const stepped = drawing.stepped && !isExact
    pen.stroke(lineThrough(spots, stepped))
    pen.restore()
    if (isExact) continue
    pen.fillStyle = colour
    drawMarks(pen, curve.look, spots, { box, stepped, radius: isSelected ? 4.5 : 3.5 })
  }
}

/** The places of a curve [px]. Far outside the canvas all are alike: it can't tell them apart either. */
function spotsOf({ x, y }: Curve, { across, up }: Drawing, box: Box): Point[] {
  const width = (box.right - box.left) / (across.to - across.from)
  const height = (box.bottom - box.top) / (up.to - up.from)
  return x.map((at, i) => ({
    x: clamp(box.left + (at - across.from) * width, -1e5, 1e5),
    y: clamp(box.bottom - (y[i]! - up.from) * height, -1e5, 1e5),
  }))
}

/** In steps where what is shown stays as it is until the next frame. */
function lineThrough(spots: readonly Point[], stepped: boolean): Path2D {
  const path = new Path2D()
  spots.forEach(({ x, y }, i) => {
    if (stepped && i > 0) path.lineTo(x, spots[i - 1]!.y)
    path.lineTo(x, y)
  })
  return path
}
