import { moved } from '../../chart/geometry.ts'
import type { Point } from '../../chart/geometry.ts'
import { line } from '../../chart/graph.ts'
import { degrees } from '../../chart/numbers.ts'
import { write } from '../../chart/text.ts'
import { drawArrow } from '../../view/arrows.ts'
import type { Palette } from '../../view/palette.ts'
import type { ArrowId } from '../../view/picture.ts'
import type { DrawingSurface } from './figure.ts'

/** A slope through a point of the canvas about which it is turned; uphill is to the right. */
export interface Slope {
  readonly at: Point
  /** [rad] */
  readonly angle: number
  /** Unit vectors downhill and out of the ground. */
  readonly along: Point
  readonly out: Point
}

/** @param angle in degrees */
export function slopeThrough(at: Point, angle: number): Slope {
  const radians = (angle * Math.PI) / 180
  const [sin, cos] = [Math.sin(radians), Math.cos(radians)]
  return { at, angle: radians, along: { x: -cos, y: sin }, out: { x: -sin, y: -cos } }
}

/** The angle of a slope through `at` whose uphill part goes through a point [°]. */
export function angleTowards(at: Point, { x, y }: Point): number {
  return (Math.atan2(at.y - y, x - at.x) * 180) / Math.PI
}

/** The ground from one edge of the canvas to the other. */
export function drawSlope(
  context: CanvasRenderingContext2D,
  { at, along }: Slope,
  { width, height }: { readonly width: number; readonly height: number },
  palette: Palette,
): void {
  const reach = width + height
  const [top, foot] = [moved(at, along, -reach), moved(at, along, reach)]
  context.fillStyle = palette.ground
  context.beginPath()
  context.moveTo(foot.x, foot.y)
  context.lineTo(top.x, top.y)
  context.lineTo(top.x, height + reach)
  context.lineTo(foot.x, height + reach)
  context.fill()
  context.strokeStyle = palette.ink
  context.lineWidth = 1.75
  line(context, foot, top)
}

/** The angle at a point of the slope, with the level it is measured from. */
export function drawSlopeAngle(
  context: CanvasRenderingContext2D,
  { angle }: Slope,
  vertex: Point,
  radius: number,
  palette: Palette,
): void {
  context.strokeStyle = palette.inkSoft
  context.lineWidth = 1
  context.setLineDash([4, 4])
  line(context, vertex, { x: vertex.x + radius + 48, y: vertex.y })
  context.setLineDash([])
  context.beginPath()
  context.arc(vertex.x, vertex.y, radius, -angle, 0)
  context.stroke()
  context.font = `16px ${palette.sans}`
  context.fillStyle = palette.ink
  const text = degrees(Number(((angle * 180) / Math.PI).toFixed(1)))
  // Where the slope leaves no room above the level, under it.
  const hasRoom = (radius + 8) * Math.tan(angle) > 26
  const y = hasRoom ? vertex.y - 7 : vertex.y + 18
  write(context, text, vertex.x + radius + 8, y, { halo: palette.ground })
}

/** A block with its middle at a point. */
export function drawBlock(
  context: CanvasRenderingContext2D,
  middle: Point,
  {
    angle,
    size,
    fill,
    pale = false,
  }: {
    readonly angle: number
    readonly size: number
    readonly fill: string
    /** Under arrows that have to be seen. */
    readonly pale?: boolean
  },
): void {
  context.save()
  context.translate(middle.x, middle.y)
  context.rotate(-angle)
  const { globalAlpha } = context
  context.globalAlpha = (pale ? 0.24 : 0.86) * globalAlpha
  context.fillStyle = context.strokeStyle = fill
  context.beginPath()
  context.roundRect(-size / 2, -size / 2, size, size, 4)
  context.fill()
  context.globalAlpha = globalAlpha
  context.lineWidth = 1.5
  context.stroke()
  context.restore()
}

/** An arrow with letters at its tip. */
export interface NamedArrow {
  readonly id: ArrowId
  readonly tag: string
  readonly from: Point
  readonly to: Point
  /** One of a whole's parts, or what is only possible. */
  readonly dashed?: true
}

/**
 * Draws arrows that are long enough to be seen, and writes at their tips. With one of them `lit`, the others are faint.
 */
export function drawNamedArrows(
  context: CanvasRenderingContext2D,
  arrows: readonly NamedArrow[],
  palette: Palette,
  lit?: string,
): void {
  const seen = arrows.filter(({ from, to }) => Math.hypot(to.x - from.x, to.y - from.y) > 2)
  const isLit = seen.some(({ id }) => id === lit)
  const strength = (id: ArrowId) => (isLit && id !== lit ? 0.2 : 1)
  for (const { id, from, to, dashed } of seen) {
    context.globalAlpha = strength(id)
    const colour = palette.arrows[id]
    const width = id === 'sum' ? 4 : 2.75
    drawArrow(context, from, to, { colour: palette.sheet, width: width + 3, head: 0 })
    context.setLineDash(dashed ? [5, 4] : [])
    drawArrow(context, from, to, { colour, width, head: 13 })
    context.setLineDash([])
  }
  context.font = `600 14px ${palette.sans}`
  for (const { id, tag, from, to } of seen) {
    const length = Math.hypot(to.x - from.x, to.y - from.y)
    const [x, y] = [(to.x - from.x) / length, (to.y - from.y) / length]
    const align = x > 0.35 ? 'left' : x < -0.35 ? 'right' : 'center'
    context.globalAlpha = strength(id)
    context.fillStyle = palette.arrows[id]
    // Friction's tip is on the edge of the ground, where letters can't be read.
    const down = id === 'friction' ? 12 : 0
    write(context, tag, to.x + 9 * x, to.y + 14 * y + 5 + down, { align, halo: palette.sheet })
  }
  context.globalAlpha = 1
}

/** A slope to scale, from edge to edge, on which a block goes up to so many metres away from a mark near its foot. */
interface LongSlope {
  readonly slope: Slope
  /** [px/m] */
  readonly scale: number
  /** The point of the ground so many metres uphill of the mark. */
  readonly at: (uphill: number) => Point
}

/**
 * Where a slope of an angle [°] lies that shows `metres` uphill of the mark, its foot so high over the lower edge [px].
 */
export function longSlope(
  { width, height }: Pick<DrawingSurface, 'width' | 'height'>,
  angle: number,
  metres: number,
  foot: number,
): LongSlope {
  const start = { x: 0.09 * width + 12, y: height - foot }
  const slope = slopeThrough(start, angle)
  const wide = (0.87 * width - start.x) / Math.cos(slope.angle)
  const high = (start.y - 0.3 * height) / Math.sin(slope.angle)
  const scale = Math.min(wide, high) / metres
  return { slope, scale, at: (uphill) => moved(start, slope.along, -uphill * scale) }
}

/** Draws it with a tick for every metre. */
export function drawLongSlope(
  surface: DrawingSurface,
  { slope, at }: LongSlope,
  metres: number,
): void {
  const { context, palette } = surface
  drawSlope(context, slope, surface, palette)
  context.strokeStyle = context.fillStyle = palette.inkSoft
  context.lineWidth = 1
  context.font = `12px ${palette.sans}`
  for (let i = 0; i <= metres; i++) {
    const place = at(i)
    line(context, place, moved(place, slope.out, -7))
    const text = moved(place, slope.out, -19)
    write(context, i === 0 ? '0 m' : String(i), text.x, text.y + 4, { align: 'center' })
  }
}

/** A flag planted in the ground at a point. */
export function drawFlag(surface: DrawingSurface, at: Point, height: number, colour: string): void {
  const { context } = surface
  const top = at.y - height
  context.strokeStyle = context.fillStyle = colour
  context.lineWidth = 2
  line(context, at, { x: at.x, y: top })
  context.beginPath()
  context.moveTo(at.x, top)
  context.lineTo(at.x + 22, top + 8)
  context.lineTo(at.x, top + 16)
  context.fill()
}
