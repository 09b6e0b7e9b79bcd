import type { Box, Point } from '../../chart/geometry.ts'
import { graphIn } from '../../chart/graph.ts'
import type { Graph } from '../../chart/graph.ts'
import { cleared } from '../../chart/pen.ts'
import { markOf } from '../../view/marks.ts'
import type { Palette } from '../../view/palette.ts'
import { boxOf, clip } from './chart.ts'
import { EXACT } from './curves.ts'
import type { PlotDrawing } from './curves.ts'
import type { PlotReading } from './readings.ts'

/** What a plot's cursor points at. */
export interface Pointed {
  readonly drawing: PlotDrawing
  /** Of the canvas [px]. */
  readonly width: number
  readonly height: number
  /** Of the transport [s]. */
  readonly time: number
  /** Where a pointer is, if it is over a plot [s]. */
  readonly hover: number | undefined
  /** Of the time that is looked at. */
  readonly readings: readonly PlotReading[]
}

/** Draws the transport's time, that of the pointer, and each runner's mark at its value then. */
export function drawCursor(canvas: HTMLCanvasElement, pointed: Pointed, palette: Palette): void {
  const { drawing, width, height, time, hover, readings } = pointed
  const pen = cleared(canvas, width, height)
  const box = boxOf(width, height)
  const graph = graphIn(box, drawing.across, drawing.up)
  pen.save()
  clip(pen, box, 6)
  if (drawing.stepped) {
    drawLine(pen, graph, time, palette.accent, hover === undefined ? 1.5 : 1)
    if (hover !== undefined) drawLine(pen, graph, hover, palette.ink, 1)
  }
  for (const { paletteIndex, x, y } of readings) {
    const over = drawing.stepped ? (hover ?? time) : x
    const spot = { x: graph.x(over), y: graph.y(y) }
    if (!Number.isFinite(spot.x) || !Number.isFinite(spot.y)) continue
    pen.lineWidth = 3
    pen.strokeStyle = palette.sheet
    pen.fillStyle = paletteIndex === EXACT ? palette.ink : palette.runners[paletteIndex]!.fill
    const mark = paletteIndex === EXACT ? disc() : markOf(paletteIndex, 5.5)
    pen.translate(spot.x, spot.y)
    pen.stroke(mark)
    pen.fill(mark)
    pen.translate(-spot.x, -spot.y)
  }
  pen.restore()
}

/** The time that a point of a chart belongs to [s]: over time that below it, else that of the nearest frame shown. */
export function timeAt(
  { across, up, curves, stepped }: PlotDrawing,
  box: Box,
  point: Point,
): number {
  const part = (point.x - box.left) / (box.right - box.left)
  if (stepped)
    return Math.min(
      across.to,
      Math.max(across.from, across.from + part * (across.to - across.from)),
    )
  const { column, row } = graphIn(box, across, up)
  let nearest = Infinity
  let time = 0
  for (const curve of curves) {
    for (let i = 0; i < curve.x.length; i++) {
      const distance = (column(curve.x[i]!) - point.x) ** 2 + (row(curve.y[i]!) - point.y) ** 2
      if (distance >= nearest) continue
      nearest = distance
      time = curve.time[i]!
    }
  }
  return time
}

function drawLine(
  pen: CanvasRenderingContext2D,
  { box, x }: Graph,
  time: number,
  colour: string,
  width: number,
): void {
  pen.strokeStyle = colour
  pen.lineWidth = width
  pen.beginPath()
  pen.moveTo(x(time), box.top)
  pen.lineTo(x(time), box.bottom)
  pen.stroke()
}

function disc(): Path2D {
  const path = new Path2D()
  path.arc(0, 0, 3, 0, 2 * Math.PI)
  return path
}
