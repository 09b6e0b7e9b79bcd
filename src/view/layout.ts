import type { Parameters } from '../physics/index.ts'
import type { Point } from '../chart/geometry.ts'
import { fit } from './camera.ts'
import type { Camera } from './camera.ts'
import { extentOf } from './extent.ts'
import type { Extent } from './extent.ts'
import type { Picture } from './picture.ts'
import { worldPoint } from './projection.ts'
import { viewOf } from './scenes.ts'
import { sizesOf } from './sizes.ts'
import type { Sizes } from './sizes.ts'
import { highestFoot, slopeRoom, subjectsOf } from './subjects.ts'

/** How a picture is laid out on a canvas: all sizes in CSS pixels, all places along the track in metres. */
export interface Layout extends Sizes {
  readonly width: number
  readonly height: number
  readonly camera: Camera
  /** What of the track the run covers. */
  readonly extent: Extent
  /** The ends of a slope: `from` is the upper one, where the handle is. */
  readonly ends: Extent
  /** Where the point of the track that keeps still under a drag lies. */
  readonly pin: Point
}

/** Lays a picture out so that the whole run is seen. */
export function layOut(picture: Picture, width: number, height: number): Layout {
  const extent = extentOf(picture)
  const sizes = sizesOf(picture, width, height)
  const subjects = subjectsOf(picture, extent, sizes, height)
  const fitted = fit(subjects, width, height)
  // A fall has but one direction: its column stands where the labels to the right of it have room.
  const camera = viewOf(picture.scene).falls ? { ...fitted, x: Math.round(0.36 * width) } : fitted
  const room = slopeRoom(picture, sizes.block)
  const ends = {
    from: highestFoot(picture, extent) - room.top / camera.scale,
    to: extent.to + room.foot / camera.scale,
  }
  const still = worldPoint(
    picture.scene,
    picture.parameters,
    stillAt(picture, picture.parameters, ends),
  )
  const pin = { x: camera.x + camera.scale * still.x, y: camera.y - camera.scale * still.y }
  return { width, height, camera, extent, ends, pin, ...sizes }
}

/** The same view for a picture that has changed: scale, ends and the foot of the slope stay where they are. */
export function held(layout: Layout, picture: Picture): Layout {
  return {
    ...layout,
    extent: extentOf(picture),
    camera: heldCamera(layout, picture, picture.parameters),
  }
}

/** The camera that keeps the foot of the slope in its place at other parameters. */
export function heldCamera(layout: Layout, picture: Picture, parameters: Parameters): Camera {
  const { scale } = layout.camera
  const still = worldPoint(picture.scene, parameters, stillAt(picture, parameters, layout.ends))
  return { scale, x: layout.pin.x - scale * still.x, y: layout.pin.y + scale * still.y }
}

/** The point of the track about which a slope is tilted [m]: its foot, or the top of a hill. */
function stillAt({ scene }: Picture, parameters: Parameters, ends: Extent): number {
  const { bend: bendOf, climbs } = viewOf(scene)
  const bend = bendOf?.(parameters)
  if (bend?.joined) return climbs ? (bend.from + bend.to) / 2 : bend.to
  return 'angle' in parameters ? ends.to : 0
}
