import { moved } from '../chart/geometry.ts'
import type { Actor } from './actors.ts'
import { centre, fillBody } from './body.ts'
import type { Palette } from './palette.ts'

/** A runner's block; where its run has gone wrong it fades under a sign of it. */
export function drawRunner(
  context: CanvasRenderingContext2D,
  actor: Actor,
  palette: Palette,
): void {
  const { runner, end, body, beyond } = actor
  if (!runner) return
  const { fill } = palette.runners[runner.paletteIndex]!
  const wrong = end && end.kind !== 'at-rest'
  context.save()
  if (wrong || beyond !== 0) context.globalAlpha = 0.25
  fillBody(context, body, { paletteIndex: runner.paletteIndex, fill, mark: palette.sheet })
  context.restore()
  if (wrong) drawCross(context, actor, fill)
  else if (beyond !== 0) drawChevron(context, actor, beyond, fill)
}

function drawCross(context: CanvasRenderingContext2D, { body }: Actor, colour: string): void {
  const { x, y } = centre(body)
  const r = 0.26 * body.size
  context.strokeStyle = colour
  context.lineWidth = 3.5
  context.lineCap = 'round'
  context.beginPath()
  context.moveTo(x - r, y - r)
  context.lineTo(x + r, y + r)
  context.moveTo(x - r, y + r)
  context.lineTo(x + r, y - r)
  context.stroke()
  context.lineCap = 'butt'
}

/** Out of the picture, that way. */
function drawChevron(
  context: CanvasRenderingContext2D,
  { body }: Actor,
  beyond: -1 | 1,
  colour: string,
): void {
  const { along, out } = body.spot
  const r = 0.24 * body.size
  const tip = moved(centre(body), along, beyond * r)
  const back = moved(tip, along, -beyond * r)
  context.strokeStyle = colour
  context.lineWidth = 3
  context.lineJoin = 'miter'
  context.beginPath()
  for (const { x, y } of [moved(back, out, r), tip, moved(back, out, -r)]) context.lineTo(x, y)
  context.stroke()
}
