import { clamp } from '../chart/geometry.ts'
import type { Point } from '../chart/geometry.ts'
import { roundAbove, toStep } from '../chart/ticks.ts'
import { bodyAt } from './actors.ts'
import { centre } from './body.ts'
import { withParameter, handleAt } from './handles.ts'
import { heldCamera } from './layout.ts'
import type { Layout } from './layout.ts'
import type { HandleId, Picture } from './picture.ts'
import { Projection } from './projection.ts'
import { ARROW_START } from './sizes.ts'

/** The finest tilt [°]. */
const ANGLE_STEP = 0.5

/** The change of parameters that brings a handle as near to a point as it can come, in round numbers. */
export function dragged(
  id: HandleId,
  to: Point,
  picture: Picture,
  layout: Layout,
): Record<string, number> {
  if (id === 'tilt') return { angle: angleNear(to, picture, layout) }
  if (id === 'place') return { position: positionNear(to, picture, layout) }
  return { speed: speedNear(to, picture, layout) }
}

/** Of all angles the one whose handle is nearest. It asks the track itself, so that every slope can be tilted. */
function angleNear(to: Point, picture: Picture, layout: Layout): number {
  const { min, max } = picture.scene.parameters.angle!
  const count = Math.round((max - min) / ANGLE_STEP)
  return nearest(
    Array.from({ length: count + 1 }, (_, i) => min + i * ANGLE_STEP),
    to,
    (angle) => {
      const tilted = withParameter(picture, 'angle', angle)
      const camera = heldCamera(layout, picture, tilted.parameters)
      return handleAt('tilt', tilted, { ...layout, camera })
    },
  )!
}

/** Of all round places on the canvas that the scene allows the one whose block is nearest. */
function positionNear(to: Point, picture: Picture, layout: Layout): number {
  const { scene, parameters } = picture
  const { camera, width, height, extent } = layout
  const step = roundAbove(3.5 / camera.scale)
  const { min, max } = scene.parameters.position!
  const reach = (width + height) / camera.scale
  const first = Math.ceil(Math.max(min, extent.from - reach) / step)
  const last = Math.floor(Math.min(max, extent.to + reach) / step)
  const projection = new Projection(scene, parameters, camera)
  const places: number[] = []
  for (let i = first; i <= last; i++) {
    const position = toStep(i * step, step)
    if (!scene.conflict?.({ ...parameters, position })) places.push(position)
  }
  return (
    nearest(places, to, (s) => centre(bodyAt(s, picture, layout, projection))) ??
    parameters.position!
  )
}

/** As fast as the arrow is long; within the block, not at all. */
function speedNear(to: Point, picture: Picture, layout: Layout): number {
  const projection = new Projection(picture.scene, picture.parameters, layout.camera)
  const body = bodyAt(picture.parameters.position!, picture, layout, projection)
  const middle = centre(body)
  const { along } = body.spot
  const distance = (to.x - middle.x) * along.x + (to.y - middle.y) * along.y
  const speed = Math.sign(distance) * (Math.max(0, Math.abs(distance) - ARROW_START) / layout.arrow)
  const { min, max } = picture.scene.parameters.speed!
  return clamp(toStep(speed, roundAbove(2 / layout.arrow)), min, max)
}

function nearest(
  values: readonly number[],
  to: Point,
  at: (value: number) => Point,
): number | undefined {
  let best: number | undefined
  let least = Infinity
  for (const value of values) {
    const { x, y } = at(value)
    const distance = (x - to.x) ** 2 + (y - to.y) ** 2
    if (distance < least) {
      least = distance
      best = value
    }
  }
  return best
}
