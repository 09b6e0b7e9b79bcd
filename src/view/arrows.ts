import { moved } from '../chart/geometry.ts'
import type { Point } from '../chart/geometry.ts'

/** An arrow from one point to another, its head at most as long as itself. */
export function drawArrow(
  context: CanvasRenderingContext2D,
  from: Point,
  to: Point,
  { colour, width, head }: { colour: string; width: number; head: number },
): void {
  const length = Math.hypot(to.x - from.x, to.y - from.y)
  if (length < 1) return
  const along = { x: (to.x - from.x) / length, y: (to.y - from.y) / length }
  const across = { x: -along.y, y: along.x }
  const size = Math.min(head, length)
  const neck = moved(to, along, -size)
  context.strokeStyle = context.fillStyle = colour
  context.lineWidth = width
  context.beginPath()
  context.moveTo(from.x, from.y)
  context.lineTo(neck.x, neck.y)
  context.stroke()
  context.beginPath()
  for (const { x, y } of [
    to,
    moved(neck, across, 0.42 * size),
    moved(neck, across, -0.42 * size),
  ]) {
    context.lineTo(x, y)
  }
  context.fill()
}
