import { drawnBetween, shortAxis } from './axis.ts'
import type { Axis } from './axis.ts'
import type { Box, Point } from './geometry.ts'
import { write } from './text.ts'

/** The two ends of an axis. */
export type Range = readonly [from: number, to: number]

/** A box of the canvas with an axis across and one up. */
export interface Graph {
  readonly box: Box
  readonly across: Axis
  readonly up: Axis
  /** Where a point of an axis is on the canvas [px]. */
  readonly column: (at: number) => number
  readonly row: (at: number) => number
  /** Where a value is on the canvas [px]. */
  readonly x: (value: number) => number
  readonly y: (value: number) => number
}

export function graphIn(box: Box, across: Range | Axis, up: Range | Axis): Graph {
  const [wide, high] = [axisFrom(across), axisFrom(up)]
  const column = drawnBetween(wide, box.left, box.right)
  const row = drawnBetween(high, box.bottom, box.top)
  return {
    ...{ box, across: wide, up: high, column, row },
    x: (value) => column(wide.at(value)),
    y: (value) => row(high.at(value)),
  }
}

function axisFrom(given: Range | Axis): Axis {
  return 'ticks' in given ? given : shortAxis(...given)
}

/** The names at the ends of the axes: “speed, m/s”. */
export interface AxisNames {
  readonly across?: string
  readonly up?: string
}

/** The colours and the typeface of axes. */
interface AxisPalette {
  readonly line: string
  /** Of the line at 0. */
  readonly edge: string
  readonly inkSoft: string
  readonly sans: string
}

/** The sizes of axes [px]. */
export interface AxisSizes {
  readonly font: number
  /** The room that a tick needs. */
  readonly across: number
  readonly up: number
  /** From the box to the right end of a label, and down to the baseline of one. */
  readonly left: number
  readonly below: number
  /** Of the pixels that a line is to cover whole. */
  readonly ratio: number
}

const ample: AxisSizes = { font: 12, across: 64, up: 34, left: 7, below: 16, ratio: 1 }

/** Draws lines at the ticks, their labels, a stronger line at 0, and the names of the axes. */
export function drawAxes(
  context: CanvasRenderingContext2D,
  { box, across, up, column, row }: Graph,
  names: AxisNames,
  palette: AxisPalette,
  sizes = ample,
): void {
  const { left, right, top, bottom } = box
  context.lineWidth = 1
  context.font = `${sizes.font}px ${palette.sans}`
  for (const { at, label } of up.ticks((bottom - top) / sizes.up)) {
    const height = crisp(row(at), sizes)
    context.strokeStyle = at === 0 ? palette.edge : palette.line
    line(context, { x: left, y: height }, { x: right, y: height })
    context.fillStyle = palette.inkSoft
    write(context, label, left - sizes.left, height + sizes.font / 3, { align: 'right' })
  }
  for (const { at, label } of across.ticks((right - left) / sizes.across)) {
    const place = crisp(column(at), sizes)
    context.strokeStyle = palette.line
    line(context, { x: place, y: top }, { x: place, y: bottom })
    // The last label gives way to the axis's name.
    if (names.across && place > right - 9 - 7 * names.across.length) continue
    context.fillStyle = palette.inkSoft
    write(context, label, place, bottom + sizes.below, { align: 'center' })
  }
  context.fillStyle = palette.inkSoft
  if (names.across) write(context, names.across, right, bottom + sizes.below, { align: 'right' })
  if (names.up) write(context, names.up, left, top - 8)
}

/** The nearest place where a line one pixel wide covers whole pixels. */
function crisp(at: number, { ratio }: AxisSizes): number {
  const half = (Math.round(ratio) % 2) / 2
  return (Math.round(at * ratio) + half) / ratio
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

/** Clips drawing to a box until the context is restored. */
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
