import type { Parameters } from '../physics/index.ts'
import { moved } from '../chart/geometry.ts'
import type { Point } from '../chart/geometry.ts'
import { fit, worldPoint, Projection } from './projection.ts'
import type { Camera, Subject } from './projection.ts'
import { extentOf } from './extent.ts'
import type { Extent } from './extent.ts'
import type { Picture } from './picture.ts'
import { viewOf } from './scenes.ts'
import type { Bend } from './scenes.ts'
import { arrowReach, beltDepth, sizesOf } from './sizes.ts'
import type { Sizes } from './sizes.ts'

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

/** How far a slope goes on beyond the run: a spring needs room above for its coil, a belt at its end for a roller. */
function slopeRoom({ scene }: Picture, block: number): { top: number; foot: number } {
  const { spring, speed } = viewOf(scene)
  return { top: spring ? 2.6 * block : 1.6 * block, foot: speed ? 1.7 * block : 0.75 * block }
}

/** How far along it a slope may begin [m]: where the run does, and a hill on the straight that leads up to it. */
function highestFoot({ scene, parameters }: Picture, { from }: Extent): number {
  const { climbs, bend } = viewOf(scene)
  return climbs ? Math.min(from, bend!(parameters).from) : from
}

/** Everything that must be seen, with the room around it. */
function subjectsOf(picture: Picture, extent: Extent, sizes: Sizes, height: number): Subject[] {
  const { scene, parameters, runners } = picture
  const { block, lanes, row } = sizes
  const unit = new Projection(scene, parameters, { scale: 1, x: 0, y: 0 })
  const subject = (s: number, left: number, right: number, above: number, below: number) => ({
    ...worldPoint(scene, parameters, s),
    ...{ left, right, above, below },
  })
  /** Room for a point that is so many pixels away from the place s, and for what is around it. */
  const beside = (s: number, offset: Point, rim: number) =>
    subject(s, rim - offset.x, rim + offset.x, rim - offset.y, rim + offset.y)

  const { falls, bend: bendOf, speed } = viewOf(scene)
  // From the block's middle to the end of the letters at the longest arrow's tip.
  const reach = picture.forces ? sizes.force + 20 : 0
  const side = Math.max(0.8 * block, 0.8 * reach)
  // A stack that would take half the canvas goes on beside itself.
  const labels = Math.min((runners.length + 1) * row + 1.35 * block + 12, 0.46 * height)
  // At the start the labels stand on the arrow's number.
  const number = 24
  // Labels keep clear of the arrows too.
  const stack = Math.min(labels + 0.35 * reach, Math.max(labels, 0.5 * height))
  const above = falls ? Math.max(block, reach) : Math.max(stack, reach + block / 2)
  const depth = speed ? beltDepth(lanes) + 30 : lanes.depth + 34
  const below = falls ? Math.max(block, reach) : Math.max(depth, reach - block / 2)
  const subjects = samples(extent).map((s) => subject(s, side, side, above, below))

  const start = parameters.position!
  subjects.push(subject(start, side, side, Math.min(above + number, 0.46 * height), below))
  const { along, out } = unit.at(start)
  const middle = moved({ x: 0, y: 0 }, out, block / 2)
  subjects.push(beside(start, moved(middle, along, arrowReach(picture, sizes.arrow)), 30))
  if (falls) return subjects

  const room = slopeRoom(picture, block)
  const bend = bendOf?.(parameters)
  if (bend && !bend.joined) {
    for (const s of lips(bend, extent)) subjects.push(subject(s, 26, 26, 18, 40))
  } else {
    const first = highestFoot(picture, extent)
    subjects.push(beside(first, moved({ x: 0, y: 0 }, unit.at(first).along, -room.top), 26))
    const foot = moved({ x: 0, y: 0 }, unit.at(extent.to).along, room.foot)
    subjects.push(beside(extent.to, foot, 20))
    if (bend) subjects.push(subject(bend.to, 20, 60, 20, below))
  }
  return subjects
}

/** The ends of a track that bends between them, or of the part of it around a run that is much smaller. */
function lips(bend: Bend, { from, to }: Extent): [number, number] {
  const more = 4 * (to - from)
  return [Math.max(bend.from, from - more), Math.min(bend.to, to + more)]
}

function samples({ from, to }: Extent): number[] {
  return Array.from({ length: 33 }, (_, i) => from + ((to - from) * i) / 32)
}
