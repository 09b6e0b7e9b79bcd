import type { Parameters } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import type { Point } from '../chart/geometry.ts'
import { bodyAt } from './actors.ts'
import { centre } from './body.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Handle, HandleId, Picture } from './picture.ts'
import { Projection } from './projection.ts'
import { arrowReach } from './sizes.ts'

/** The parameter that a handle changes. */
export const parameterOf = {
  tilt: 'angle',
  place: 'position',
  push: 'speed',
} as const satisfies Record<HandleId, string>

/** The handles that a scene has. */
export function handlesOf(picture: Picture, layout: Layout): Handle[] {
  return (picture.handles ?? (['tilt', 'place', 'push'] as const))
    .filter((id) => parameterOf[id] in picture.scene.parameters)
    .map((id) => ({ id, parameter: parameterOf[id], ...handleAt(id, picture, layout) }))
}

/** Where a handle stands in a picture. */
export function handleAt(id: HandleId, picture: Picture, layout: Layout): Point {
  const { scene, parameters } = picture
  const projection = new Projection(scene, parameters, layout.camera)
  if (id === 'tilt') return projection.at(layout.ends.from)
  const body = bodyAt(parameters.position!, picture, layout, projection)
  if (id === 'place') return centre(body)
  return moved(centre(body), body.spot.along, arrowReach(picture, layout.arrow))
}

/** The picture with one parameter changed. */
export function withParameter(picture: Picture, name: string, value: number): Picture {
  const parameters: Parameters = { ...picture.parameters, [name]: value }
  return { ...picture, parameters }
}

/** Discs to take hold of: larger with a halo where one is pointed at. */
export function drawHandles(
  context: CanvasRenderingContext2D,
  handles: readonly Handle[],
  { lit, held }: Picture,
  palette: Palette,
): void {
  for (const handle of handles)
    drawDisc(context, handle, handle.id === lit || handle.id === held, palette)
}

/** A disc to take hold of. */
export function drawDisc(
  context: CanvasRenderingContext2D,
  { x, y }: Point,
  strong: boolean,
  palette: Palette,
): void {
  if (strong) {
    context.globalAlpha = 0.22
    disc(context, x, y, 17)
    context.fillStyle = palette.accent
    context.fill()
    context.globalAlpha = 1
  }
  disc(context, x, y, strong ? 8 : 6.5)
  context.fillStyle = palette.paper
  context.fill()
  context.strokeStyle = palette.accent
  context.lineWidth = 2.5
  context.stroke()
}

function disc(context: CanvasRenderingContext2D, x: number, y: number, radius: number): void {
  context.beginPath()
  context.arc(x, y, radius, 0, 2 * Math.PI)
}
