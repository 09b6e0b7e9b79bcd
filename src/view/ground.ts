import type { Point } from '../chart/geometry.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'
import { viewOf } from './scenes.ts'
import type { Bend } from './scenes.ts'

/** The ends of the track as drawn: beyond them it is level. A run that outgrows a held view takes them along. */
export function drawnEnds({ ends, extent, camera, block }: Layout): { from: number; to: number } {
  const room = (0.75 * block) / camera.scale
  return { from: Math.min(ends.from, extent.from - room), to: Math.max(ends.to, extent.to + room) }
}

/** The surface of the ground from the left edge of the canvas to the right one. */
export function outline(picture: Picture, layout: Layout, projection: Projection): Point[] {
  const points = distances(picture, layout).map((s) => projection.at(s))
  if (picture.scene.facing < 0) points.reverse()
  const first = points[0]!
  const last = points[points.length - 1]!
  const edge = layout.width + 2
  return [
    { x: Math.min(-2, first.x), y: first.y },
    ...points,
    { x: Math.max(edge, last.x), y: last.y },
  ]
}

/** The places of the track that its outline goes through. */
function distances({ scene, parameters }: Picture, layout: Layout): number[] {
  const { from, to } = drawnEnds(layout)
  const bend = viewOf(scene).bend?.(parameters)
  if (!bend) return [from, to]
  if (!bend.joined) return pipe(bend, layout)
  const right = bend.to + (2 * layout.width) / layout.camera.scale
  return [Math.min(from, bend.from), ...range(bend.from, bend.to, 48), right]
}

/** The pipe between its lips, or as much of it as can be on the canvas. */
function pipe({ from, to }: Bend, { extent, width, height, camera }: Layout): number[] {
  const middle = (extent.from + extent.to) / 2
  const reach = (width + height) / camera.scale
  return range(Math.max(from, middle - reach), Math.min(to, middle + reach), 160)
}

function range(from: number, to: number, parts: number): number[] {
  return Array.from({ length: parts + 1 }, (_, i) => from + ((to - from) * i) / parts)
}

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
