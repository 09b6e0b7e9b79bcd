import { moved } from '../chart/geometry.ts'
import type { Point } from '../chart/geometry.ts'
import type { Subject } from './camera.ts'
import type { Extent } from './extent.ts'
import type { Picture } from './picture.ts'
import { Projection, worldPoint } from './projection.ts'
import { viewOf } from './scenes.ts'
import type { Bend } from './scenes.ts'
import { arrowReach, beltDepth } from './sizes.ts'
import type { Sizes } from './sizes.ts'

/** How far a slope goes on beyond the run: a spring needs room above for its coil, a belt at its end for a roller. */
export function slopeRoom({ scene }: Picture, block: number): { top: number; foot: number } {
  const { spring, speed } = viewOf(scene)
  return { top: spring ? 2.6 * block : 1.6 * block, foot: speed ? 1.7 * block : 0.75 * block }
}

/** How far along it a slope may begin [m]: where the run does, and a hill on the straight that leads up to it. */
export function highestFoot({ scene, parameters }: Picture, { from }: Extent): number {
  const { climbs, bend } = viewOf(scene)
  return climbs ? Math.min(from, bend!(parameters).from) : from
}

/** Everything that must be seen, with the room around it. */
export function subjectsOf(
  picture: Picture,
  extent: Extent,
  sizes: Sizes,
  height: number,
): Subject[] {
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
