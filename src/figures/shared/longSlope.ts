import { moved } from '../../chart/geometry.ts'
import type { Point } from '../../chart/geometry.ts'
import { line } from '../../chart/graph.ts'
import { write } from '../../chart/text.ts'
import type { DrawingSurface } from './figure.ts'
import { drawSlope, slopeThrough } from './slope.ts'
import type { Slope } from './slope.ts'

/** A slope to scale, from edge to edge, on which a block goes up to so many metres away from a mark near its foot. */
export interface LongSlope {
  readonly slope: Slope
  /** [px/m] */
  readonly scale: number
  /** The point of the ground so many metres uphill of the mark. */
  readonly at: (uphill: number) => Point
}

/** Where a slope of an angle [°] lies that shows `metres` uphill of the mark, its foot so high over the lower edge [px]. */
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
