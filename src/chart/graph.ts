import type { Box, Point } from './geometry.ts'
import { fixed } from './numbers.ts'
import type { Palette } from '../view/palette.ts'
import { roundAbove } from './round.ts'
import { write } from './text.ts'

/** From where to where an axis goes. */
export type Range = readonly [from: number, to: number]

/** A box of the canvas with a linear axis across and one up. */
export interface Graph {
  readonly box: Box
  readonly across: Range
  readonly up: Range
  /** Where a value stands on the canvas [px]. */
  readonly x: (value: number) => number
  readonly y: (value: number) => number
}

export function graphIn(box: Box, across: Range, up: Range): Graph {
  const wide = (box.right - box.left) / (across[1] - across[0])
  const high = (box.bottom - box.top) / (up[1] - up[0])
  return {
    box,
    across,
    up,
    x: (value) => box.left + (value - across[0]) * wide,
    y: (value) => box.bottom - (value - up[0]) * high,
  }
}

/** What an axis is called, at its end: “speed, m/s”. */
export interface AxisNames {
  readonly across?: string
  readonly up?: string
}

/** Draws lines at round values, their figures, a stronger line at 0, and the names of the axes. */
export function drawAxes(
  context: CanvasRenderingContext2D,
  graph: Graph,
  names: AxisNames,
  palette: Palette,
): void {
  const { box, across, up, x, y } = graph
  context.lineWidth = 1
  context.font = `12px ${palette.sans}`
  for (const value of ticks(up, (box.bottom - box.top) / 34)) {
    const at = crisp(y(value))
    context.strokeStyle = value === 0 ? palette.edge : palette.line
    line(context, { x: box.left, y: at }, { x: box.right, y: at })
    context.fillStyle = palette.inkSoft
    write(context, tickText(value, up), box.left - 7, at + 4, { align: 'right' })
  }
  const columns = ticks(across, (box.right - box.left) / 64)
  for (const value of columns) {
    const at = crisp(x(value))
    context.strokeStyle = palette.line
    line(context, { x: at, y: box.top }, { x: at, y: box.bottom })
    // The last figure gives way to the axis's name.
    if (names.across && at > box.right - 9 - 7 * names.across.length) continue
    context.fillStyle = palette.inkSoft
    write(context, tickText(value, across), at, box.bottom + 16, { align: 'center' })
  }
  context.fillStyle = palette.inkSoft
  if (names.across) write(context, names.across, box.right, box.bottom + 16, { align: 'right' })
  if (names.up) write(context, names.up, box.left, box.top - 8)
}

/** A line through points; those that are no numbers are left out. */
export function drawCurve(
  context: CanvasRenderingContext2D,
  points: Iterable<Point>,
  { colour, width = 2, dash = [] }: { colour: string; width?: number; dash?: number[] },
): void {
  context.strokeStyle = colour
  context.lineWidth = width
  context.lineJoin = 'round'
  context.setLineDash(dash)
  context.beginPath()
  for (const { x, y } of points) if (Number.isFinite(x + y)) context.lineTo(x, y)
  context.stroke()
  context.setLineDash([])
}

/** From here on, until the context is restored, nothing is drawn outside a box. */
export function clipTo(context: CanvasRenderingContext2D, { left, top, right, bottom }: Box): void {
  context.beginPath()
  context.rect(left, top, right - left, bottom - top)
  context.clip()
}

export function line(context: CanvasRenderingContext2D, from: Point, to: Point): void {
  context.beginPath()
  context.moveTo(from.x, from.y)
  context.lineTo(to.x, to.y)
  context.stroke()
}

export function dot(context: CanvasRenderingContext2D, { x, y }: Point, radius: number): void {
  context.beginPath()
  context.arc(x, y, radius, 0, 2 * Math.PI)
  context.fill()
}

/** In the middle of a row of pixels. */
function crisp(at: number): number {
  return Math.round(at) + 0.5
}

function ticks([from, to]: Range, most: number): number[] {
  const step = roundAbove(Math.abs(to - from) / Math.max(1, most))
  const first = Math.ceil(Math.min(from, to) / step - 1e-9)
  const last = Math.floor(Math.max(from, to) / step + 1e-9)
  return Array.from({ length: last - first + 1 }, (_, i) =>
    Number(((first + i) * step).toPrecision(9)),
  )
}

function tickText(value: number, [from, to]: Range): string {
  const span = Math.abs(to - from)
  return fixed(value, span > 8 ? 0 : span > 0.8 ? 1 : span > 0.08 ? 2 : 3).replace(/\.0+$/, '')
}
