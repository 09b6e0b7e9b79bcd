import { clamp } from '../../chart/geometry.ts'
import type { Box, Point } from '../../chart/geometry.ts'
import { drawAxes, graphIn } from '../../chart/graph.ts'
import type { AxisSizes, Graph } from '../../chart/graph.ts'
import { cleared } from '../../chart/pen.ts'
import { markOf } from '../../view/marks.ts'
import type { Palette } from '../../view/palette.ts'
import { EXACT } from './curves.ts'
import type { Curve, PlotDrawing } from './curves.ts'

/**
 * The part of a chart of that size in which there are curves; the labels of the axes are to its left and below it [px].
 */
export function boxOf(width: number, height: number): Box {
  return { left: 66, top: 8, right: width - 14, bottom: height - 24 }
}

/** Lets a pen draw only so near to a box [px]. */
export function clip(pen: CanvasRenderingContext2D, box: Box, room: number): void {
  const { left, top, right, bottom } = box
  pen.beginPath()
  pen.rect(left - room, top - room, right - left + 2 * room, bottom - top + 2 * room)
  pen.clip()
}

/** How a chart is drawn. */
export interface ChartStyle {
  readonly palette: Palette
  /** The index of the runner whose curve is drawn stronger. */
  readonly selected: number
  /** [px] */
  readonly width: number
  readonly height: number
}

const dense: Omit<AxisSizes, 'ratio'> = { font: 11, across: 48, up: 28, left: 6, below: 15 }

/** Draws the axes and all curves, each runner's with its marks. */
export function drawChart(
  canvas: HTMLCanvasElement,
  drawing: PlotDrawing,
  style: ChartStyle,
): void {
  const { palette, selected, width, height } = style
  const pen = cleared(canvas, width, height)
  const box = boxOf(width, height)
  const graph = graphIn(box, drawing.across, drawing.up)
  drawAxes(
    pen,
    graph,
    {},
    { ...palette, edge: palette.line },
    { ...dense, ratio: devicePixelRatio },
  )
  pen.lineJoin = 'round'
  for (const curve of drawing.curves) {
    const isExact = curve.paletteIndex === EXACT
    const isSelected = curve.index === selected
    const spots = spotsOf(curve, graph)
    const colour = isExact ? palette.ink : palette.runners[curve.paletteIndex]!.fill
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
    drawMarks(pen, curve.paletteIndex, spots, { box, stepped, radius: isSelected ? 4.5 : 3.5 })
  }
}

/** The places of a curve [px]. Far outside the canvas all are alike: it can't tell them apart either. */
function spotsOf({ x, y }: Curve, { column, row }: Graph): Point[] {
  return x.map((at, i) => ({
    x: clamp(column(at), -1e5, 1e5),
    y: clamp(row(y[i]!), -1e5, 1e5),
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

/** Between two marks on a curve [px]. */
const GAP = 30

/** On a curve that runs round and round. */
const MOST = 24

/** Draws marks on frames of a runner's curve, far enough from each other to be told apart; `radius` in pixels. */
function drawMarks(
  pen: CanvasRenderingContext2D,
  paletteIndex: number,
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
  let due = (gap * (paletteIndex % 4)) / 4
  let last = 0
  spots.forEach((spot, i) => {
    if (far(i, last) < due) return
    last = i
    due = gap
    if (seen(spot)) pen.fill(markPath(paletteIndex, spot.x, spot.y, radius))
  })
}

/** A mark of a radius around a point. */
function markPath(paletteIndex: number, x: number, y: number, radius: number): Path2D {
  const path = new Path2D()
  path.addPath(markOf(paletteIndex, radius), new DOMMatrix().translate(x, y))
  return path
}
