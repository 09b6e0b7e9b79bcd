import { around, moved, overlap } from '../chart/geometry.ts'
import type { Box, Point } from '../chart/geometry.ts'
import { write } from '../chart/text.ts'
import type { Actor } from './actors.ts'
import { drawArrow } from './arrows.ts'
import { centre } from './body.ts'
import type { DrawnBody } from './body.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { ArrowId, Picture, PictureVector } from './picture.ts'

/** An arrow as it is drawn, in CSS pixels. */
export interface ForceArrow {
  readonly id: ArrowId
  readonly tag: string
  readonly from: Point
  readonly to: Point
  /** The room of the letters at its tip. */
  readonly box: Box
  /** The room of the arrow itself, in pieces. */
  readonly room: readonly Box[]
  /** It is longer than it can be drawn: only its direction is true. */
  readonly cut: boolean
  /** The tips of its two parts, along the track and across it, where it has both. */
  readonly parts: readonly Point[]
}

/** An arrow that is so much longer than the longest is cut. Only a run that blows up has any. */
const MOST = 1.5
/** Shorter ones can't be seen [px]. */
const LEAST = 1.5

/**
 * Where each arrow begins, in halves of a block away from its middle along n̂: forces along the track would lie on
 * each other otherwise. Friction acts where the block touches the track.
 */
const rails: Readonly<Record<ArrowId, number>> = {
  gravity: 0,
  normal: 0,
  friction: -0.88,
  other: 0.5,
  sum: -0.4,
  velocity: 1.45,
}

/** The arrows on a block, to one scale, their letters clear of each other and of the obstacles as far as possible. */
export function forceArrows(
  { forces, scene }: Picture,
  { body, beyond }: Actor,
  layout: Layout,
  obstacles: readonly Box[],
): ForceArrow[] {
  if (!forces || beyond !== 0) return []
  const longest = layout.force
  const taken = [...obstacles]
  const arrows: ForceArrow[] = []
  for (const vector of forces.vectors) {
    const most = vector.id === 'velocity' ? forces.fastest : forces.largest
    const scale = most > 0 ? longest / most : 0
    const onCanvas = (point: Point, factor = scale): Point => ({
      x: scene.facing * point.x * factor,
      y: -point.y * factor,
    })
    const whole = onCanvas(vector)
    const length = Math.hypot(whole.x, whole.y)
    if (!(length >= LEAST)) continue
    const cut = length > MOST * longest
    const direction = { x: whole.x / length, y: whole.y / length }
    const from = originOf(vector, body)
    const to = moved(from, direction, cut ? MOST * longest : length)
    const box = tagBox(to, direction, vector.tag, taken, layout)
    taken.push(box)
    const tagged = { id: vector.id, tag: vector.tag }
    const parts =
      vector.id === 'gravity' && !cut
        ? [forces.along, forces.across].map((unit) =>
            moved(from, onCanvas(unit, 1), scale * (vector.x * unit.x + vector.y * unit.y)),
          )
        : []
    const both = parts.every(({ x, y }) => Math.hypot(x - from.x, y - from.y) > LEAST)
    const room = pieces(from, to)
    arrows.push({ ...tagged, from, to, box, room, cut, parts: both ? parts : [] })
  }
  return arrows
}

function originOf({ id }: PictureVector, body: DrawnBody): Point {
  return moved(centre(body), body.spot.out, (rails[id] * body.size) / 2)
}

/** Small boxes along a line. */
function pieces(from: Point, to: Point): Box[] {
  const count = Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / 10)
  return Array.from({ length: count }, (_, i) => {
    const part = (i + 0.5) / count
    const x = from.x + (to.x - from.x) * part
    return around({ x, y: from.y + (to.y - from.y) * part }, 4)
  })
}

/** Before the tip, or beside it where that is taken, or further off: the first of those where the least is. */
function tagBox(
  tip: Point,
  direction: Point,
  tag: string,
  taken: readonly Box[],
  { width, height }: Layout,
): Box {
  const side = { x: -direction.y, y: direction.x }
  const half = tag.length > 1 ? 11 : 7
  const back = moved(tip, direction, -4)
  const boxes = [5, 22, 39].flatMap((far) =>
    [
      moved(tip, direction, far + half),
      moved(back, side, far + 1 + half),
      moved(back, side, -far - 1 - half),
    ].map((point) => around(point, half, 8)),
  )
  const on = boxes.filter(
    ({ left, top, right, bottom }) => left > 0 && top > 0 && right < width && bottom < height,
  )
  const crowd = (box: Box) => taken.filter((other) => overlap(box, other)).length
  return on.sort((a, b) => crowd(a) - crowd(b))[0] ?? boxes[0]!
}

/** Draws the arrows on a block, gravity's parts dashed, and the letters at the tips. */
function drawForces(
  context: CanvasRenderingContext2D,
  arrows: readonly ForceArrow[],
  { arrows: colours, sheet, sans }: Palette,
): void {
  for (const { id, from, to, parts, cut } of arrows) {
    const colour = colours[id]
    for (const part of parts) {
      dashed(context, from, part, colour)
      dashed(context, part, to, colour)
    }
    // A rim keeps it apart from the block that it lies on.
    const width = id === 'sum' ? 3.5 : 2.25
    const head = id === 'sum' ? 13 : 11
    if (cut) context.setLineDash([7, 4])
    drawArrow(context, from, to, { colour: sheet, width: width + 2.5, head: 0 })
    drawArrow(context, from, to, { colour, width, head })
    context.setLineDash([])
  }
  context.font = `600 13px ${sans}`
  for (const { id, tag, box } of arrows) {
    context.fillStyle = colours[id]
    const y = (box.top + box.bottom) / 2 + 4.5
    write(context, tag, (box.left + box.right) / 2, y, { align: 'center', halo: sheet })
  }
}

function dashed(context: CanvasRenderingContext2D, from: Point, to: Point, colour: string): void {
  context.strokeStyle = colour
  context.lineWidth = 1
  context.setLineDash([3, 3])
  context.beginPath()
  context.moveTo(from.x, from.y)
  context.lineTo(to.x, to.y)
  context.stroke()
  context.setLineDash([])
}

/** What draws forces: loaded with what can switch them on. */
export const forceDrawing = { arrows: forceArrows, draw: drawForces } as const
export type ForceDrawing = typeof forceDrawing
