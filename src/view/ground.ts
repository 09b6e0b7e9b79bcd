import type { Layout } from './layout.ts'
import { outline } from './outline.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'

/** The track, and the ground beneath it down to the canvas's edge. */
export function drawGround(
  context: CanvasRenderingContext2D,
  picture: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  const points = outline(picture, layout, projection)
  const surface = new Path2D()
  for (const { x, y } of points) surface.lineTo(x, y)
  const body = new Path2D(surface)
  body.lineTo(points[points.length - 1]!.x, layout.height + 2)
  body.lineTo(points[0]!.x, layout.height + 2)
  body.closePath()
  context.fillStyle = palette.ground
  context.fill(body)
  context.strokeStyle = palette.ink
  context.lineWidth = 1.5
  context.lineJoin = 'round'
  context.stroke(surface)
}
