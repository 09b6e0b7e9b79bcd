import { around, moved } from '../chart/geometry.ts'
import type { Box, Point } from '../chart/geometry.ts'
import { widthOf, write } from '../chart/text.ts'
import type { DrawnBody } from './body.ts'
import { drawnEnds } from './ground.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'
import { viewOf } from './scenes.ts'
import { beltDepth } from './sizes.ts'

const TURNS = 14

/** The spring from its anchor up the slope to a block, and the place where it is slack. */
export function drawSpring(
  context: CanvasRenderingContext2D,
  { spot }: DrawnBody,
  { scene }: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  const { block } = layout
  const anchor = projection.at(drawnEnds(layout).from)
  const height = block / 2
  const hook = moved(anchor, anchor.out, height)
  const end = moved(moved(spot, spot.out, height), spot.along, -block / 2)

  context.strokeStyle = palette.ink
  context.lineWidth = 3
  context.lineCap = 'round'
  // Beside a belt it hangs on a post.
  const foot = viewOf(scene).speed ? beltDepth(layout.lanes) : 0
  stroke(context, [moved(anchor, anchor.out, -foot), moved(anchor, anchor.out, block)])
  context.lineWidth = 1.5
  context.strokeStyle = palette.inkSoft
  stroke(context, coil(hook, end, anchor.out, 0.22 * block))
  context.lineCap = 'butt'
  drawSlack(context, layout, projection, palette)
}

/** A zigzag with straight ends. */
function coil(from: Point, to: Point, out: Point, amplitude: number): Point[] {
  const at = (part: number) => ({
    x: from.x + (to.x - from.x) * part,
    y: from.y + (to.y - from.y) * part,
  })
  const first = 0.07
  const points = [from, at(first)]
  for (let i = 0; i < 2 * TURNS; i++) {
    const part = first + ((1 - 2 * first) * (i + 0.5)) / (2 * TURNS)
    points.push(moved(at(part), out, i % 2 === 0 ? amplitude : -amplitude))
  }
  return [...points, at(1 - first), to]
}

function drawSlack(
  context: CanvasRenderingContext2D,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  const spot = projection.at(0)
  context.strokeStyle = palette.inkSoft
  context.lineWidth = 1
  stroke(context, [moved(spot, spot.out, 5), moved(spot, spot.out, -layout.lanes.depth - 3)])
  const { left, right, bottom } = slackBox(context, layout, projection, palette)
  context.font = slackFont(layout, palette)
  context.fillStyle = palette.inkSoft
  write(context, 'slack', (left + right) / 2, bottom, { align: 'center', halo: palette.ground })
}

/** The room of the word at the mark. */
export function slackBox(
  context: CanvasRenderingContext2D,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): Box {
  const spot = projection.at(0)
  const { font } = context
  context.font = slackFont(layout, palette)
  const half = widthOf(context, 'slack') / 2
  context.font = font
  // Beyond the mark in its own direction, so that the word never runs back into the dots.
  const at = moved(spot, spot.out, -layout.lanes.depth - 13)
  return around({ x: at.x - spot.out.x * half, y: at.y }, half, 4)
}

function slackFont({ width }: Layout, { sans }: Palette): string {
  return `${width < 480 ? 11 : 12}px ${sans}`
}

function stroke(context: CanvasRenderingContext2D, points: readonly Point[]): void {
  context.beginPath()
  for (const { x, y } of points) context.lineTo(x, y)
  context.stroke()
}
