import { moved } from './geometry.ts'
import type { Box, Point } from './geometry.ts'
import { markPath } from './marks.ts'
import type { Spot } from './projection.ts'

/** What slides, or falls: a block, or a ball, that touches the track at a spot. */
export interface Body {
  readonly spot: Spot
  /** Its side, or its diameter [px]. */
  readonly size: number
  readonly round: boolean
}

/** Its middle. In a bend a block stands on its two lower corners. */
export function centre({ spot, size, round }: Body): Point {
  return moved(spot, spot.out, size / 2 + (round ? 0 : sag(spot.curvature, size / 2)))
}

/** The middle of its top. */
export function top(body: Body): Point {
  return moved(centre(body), body.spot.out, body.size / 2)
}

/** The box around it. */
export function boundsOf(body: Body): Box {
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

/** Its outline, to fill or to stroke, drawn in by so much. */
function outlineOf(body: Body, inset = 0): Path2D {
  const { x, y } = centre(body)
  const half = body.size / 2 - inset
  const path = new Path2D()
  if (body.round) {
    path.arc(x, y, half, 0, 2 * Math.PI)
    return path
  }
  const square = new Path2D()
  square.roundRect(-half, -half, 2 * half, 2 * half, 3.5)
  path.addPath(square, new DOMMatrix().translate(x, y).rotate((body.spot.turn * 180) / Math.PI))
  return path
}

/** Fills it in a runner's colour, with the runner's mark in the middle. */
export function fillBody(
  context: CanvasRenderingContext2D,
  body: Body,
  { look, fill, mark }: { look: number; fill: string; mark: string },
): void {
  const { x, y } = centre(body)
  context.save()
  context.globalAlpha *= 0.86
  context.fillStyle = fill
  context.fill(outlineOf(body))
  context.restore()
  context.strokeStyle = fill
  context.lineWidth = 1.5
  context.stroke(outlineOf(body, 0.75))
  context.fillStyle = mark
  context.fill(markPath(look, x, y, 0.2 * body.size))
}

/** Draws only its outline. */
export function strokeBody(
  context: CanvasRenderingContext2D,
  body: Body,
  { colour, width, dash = [] }: { colour: string; width: number; dash?: number[] },
): void {
  context.strokeStyle = colour
  context.lineWidth = width
  context.setLineDash(dash)
  context.stroke(outlineOf(body, width / 2))
  context.setLineDash([])
}
