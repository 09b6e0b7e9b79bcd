import { moved } from '../chart/geometry.ts'
import type { Box, Point } from '../chart/geometry.ts'
import { markOf } from './marks.ts'
import type { Spot } from './projection.ts'

/** What slides, or falls: a block, or a ball, that touches the track at a spot. */
export interface DrawnBody {
  readonly spot: Spot
  /** Its side, or its diameter [px]. */
  readonly size: number
  readonly round: boolean
}

/** Its middle. In a bend a block stands on its two lower corners. */
export function centre({ spot, size, round }: DrawnBody): Point {
  return moved(spot, spot.out, size / 2 + (round ? 0 : sag(spot.curvature, size / 2)))
}

/** The middle of its top. */
export function top(body: DrawnBody): Point {
  return moved(centre(body), body.spot.out, body.size / 2)
}

/** The box around it. */
export function boundsOf(body: DrawnBody): Box {
  const { x, y } = centre(body)
  const { turn } = body.spot
  const spread = body.round ? 1 : Math.abs(Math.cos(turn)) + Math.abs(Math.sin(turn))
  const half = (body.size / 2) * spread
  return { left: x - half, top: y - half, right: x + half, bottom: y + half }
}

/** How deep a bend goes below a chord of that half length. */
function sag(curvature: number, half: number): number {
  if (curvature <= 0) return 0
  const part = Math.min(1, curvature * half)
  return (half * part) / (1 + Math.sqrt(1 - part * part))
}

/** The outline of a body around the origin, drawn in by so much. */
const outlines = new Map<string, Path2D>()

function outlineOf({ size, round }: DrawnBody, inset: number): Path2D {
  const half = size / 2 - inset
  const key = `${half} ${round}`
  let path = outlines.get(key)
  if (!path) {
    path = new Path2D()
    if (round) path.arc(0, 0, half, 0, 2 * Math.PI)
    else path.roundRect(-half, -half, 2 * half, 2 * half, 3.5)
    if (outlines.size > 100) outlines.clear()
    outlines.set(key, path)
  }
  return path
}

/** From here on, until the context is restored, the origin is the body's middle, and it stands upright. */
function enter(context: CanvasRenderingContext2D, body: DrawnBody): void {
  const { x, y } = centre(body)
  context.save()
  context.translate(x, y)
  if (!body.round) context.rotate(body.spot.turn)
}

/** Fills it in a runner's colour, with the runner's mark in the middle. */
export function fillBody(
  context: CanvasRenderingContext2D,
  body: DrawnBody,
  { paletteIndex, fill, mark }: { paletteIndex: number; fill: string; mark: string },
): void {
  const { globalAlpha } = context
  enter(context, body)
  context.globalAlpha = 0.86 * globalAlpha
  context.fillStyle = context.strokeStyle = fill
  context.fill(outlineOf(body, 0))
  context.globalAlpha = globalAlpha
  context.lineWidth = 1.5
  context.stroke(outlineOf(body, 0.75))
  // Marks stay upright.
  if (!body.round) context.rotate(-body.spot.turn)
  context.fillStyle = mark
  context.fill(markOf(paletteIndex, 0.2 * body.size))
  context.restore()
}

/** Draws only its outline. */
export function strokeBody(
  context: CanvasRenderingContext2D,
  body: DrawnBody,
  { colour, width, dash = [] }: { colour: string; width: number; dash?: number[] },
): void {
  context.strokeStyle = colour
  context.lineWidth = width
  enter(context, body)
  context.setLineDash(dash)
  context.stroke(outlineOf(body, width / 2))
  context.restore()
}
