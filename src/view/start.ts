import { around } from '../chart/geometry.ts'
import type { Box, Point } from '../chart/geometry.ts'
import { bodyAt } from './actors.ts'
import { drawArrow } from './arrows.ts'
import { centre, strokeBody } from './body.ts'
import { handleAt } from './handles.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'

/** The block at its start, an outline only. */
export function drawGhost(
  context: CanvasRenderingContext2D,
  picture: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  const ghost = bodyAt(picture.parameters.position!, picture, layout, projection)
  strokeBody(context, ghost, { colour: palette.inkSoft, width: 1.25, dash: [4, 3] })
}

/** The starting velocity, from the block's middle. */
export function drawPush(
  context: CanvasRenderingContext2D,
  picture: Picture,
  layout: Layout,
  palette: Palette,
): void {
  const from = handleAt('place', picture, layout)
  const tip = handleAt('push', picture, layout)
  const moving = picture.parameters.speed !== 0
  // What can't be pulled out is not drawn.
  if (!moving && picture.handles && !picture.handles.includes('push')) return
  if (!moving) context.setLineDash([2, 3])
  const head = moving ? 15 : 0
  // It ends at the handle's rim: a head under the disc would be no head.
  const rim = towards(tip, from, 6)
  drawArrow(context, from, rim, { colour: palette.accent, width: moving ? 2.5 : 1.5, head })
  context.setLineDash([])
}

function towards(from: Point, to: Point, distance: number): Point {
  const part = distance / Math.hypot(to.x - from.x, to.y - from.y)
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part }
}

/** The room that the start takes: labels keep out of it. */
export function startRoom(picture: Picture, layout: Layout, projection: Projection): Box[] {
  const ghost = bodyAt(picture.parameters.position!, picture, layout, projection)
  return [around(centre(ghost), layout.block / 2), around(handleAt('push', picture, layout), 10)]
}
