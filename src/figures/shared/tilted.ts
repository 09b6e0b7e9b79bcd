import { forcesAt, parseExperiment } from '../../physics/index.ts'
import type { Experiment, ForceVectors, State, Vector } from '../../physics/index.ts'
import { moved } from '../../chart/geometry.ts'
import type { Point } from '../../chart/geometry.ts'
import type { NumberControl } from './control.ts'
import type { Grip, DrawingSurface } from './figure.ts'
import { angleTowards, drawSlope, drawSlopeAngle, slopeThrough } from './slope.ts'
import type { NamedArrow, Slope } from './slope.ts'

/** What the figures have in common whose slope is tilted by hand, under a large block in the middle of the picture. */

/** The steepest that it can be tilted [°]. */
export const STEEPEST = 60

export const angleControl = (initial: number) =>
  ({
    type: 'number',
    label: 'Angle',
    symbol: 'α',
    unit: '°',
    from: 0,
    to: STEEPEST,
    step: 0.5,
    initial,
  }) as const satisfies NumberControl

export const muControl = (initial: number) =>
  ({
    type: 'number',
    label: 'Friction',
    symbol: 'μ',
    from: 0,
    to: 1.2,
    step: 0.05,
    initial,
  }) as const satisfies NumberControl

type Size = Pick<DrawingSurface, 'width' | 'height'>

/** The slope, and the side of the block that stands on it in the middle. */
export function tiltedSlope(
  { width, height }: Size,
  angle: number,
): { slope: Slope; size: number } {
  const at = { x: 0.46 * width, y: 0.56 * height }
  return { slope: slopeThrough(at, angle), size: Math.min(84, 0.15 * width + 20) }
}

/** The slope's end, by which it is tilted. */
export function tiltGrip(size: Size, angle: number): Grip {
  const { slope } = tiltedSlope(size, angle)
  const reach = Math.min(
    0.46 * size.width,
    (slope.at.y - 26) / Math.sin((STEEPEST * Math.PI) / 180),
  )
  return {
    control: 'angle',
    ...moved(slope.at, slope.along, -reach),
    at: (point) => angleTowards(slope.at, point),
  }
}

/** The ground, and the angle at its foot. */
export function drawTilted(surface: DrawingSurface, angle: number): void {
  const { context, width, height, palette } = surface
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, width, height)
  const { slope } = tiltedSlope(surface, angle)
  drawSlope(context, slope, surface, palette)
  // Near the left edge, or where the slope leaves the picture.
  const low = height - 26
  const x = Math.max(0.07 * width, angle > 0.25 ? footX(slope, low) : 0)
  const vertex = { x, y: footY(slope, x) }
  if (angle > 0.25) drawSlopeAngle(context, slope, vertex, 0.1 * width + 24, palette)
}

/** How high a slope is at an x of the canvas [px]. */
function footY({ at, along }: Slope, x: number): number {
  return at.y + ((x - at.x) * along.y) / along.x
}

/** Where a slope is at a height of the canvas [px]. */
function footX({ at, along }: Slope, y: number): number {
  return at.x + ((y - at.y) * along.x) / along.y
}

/** The forces on the block of an experiment at a state. */
export function forcesOn(experiment: Experiment, state: State): ForceVectors {
  return forcesAt(parseExperiment(experiment), state)
}

/** An arrow for a vector of the lab's world, from a point. */
export function arrowFor(
  id: NamedArrow['id'],
  tag: string,
  from: Point,
  { x, y }: Vector,
  scale: number,
): NamedArrow {
  // The lab's ramps fall to the left, and the canvas's y goes down.
  return { id, tag, from, to: { x: from.x - scale * x, y: from.y - scale * y } }
}
