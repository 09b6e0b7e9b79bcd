import { around, moved } from '../chart/geometry.ts'
import type { Box } from '../chart/geometry.ts'
import { actorsOf } from './actors.ts'
import type { Actor } from './actors.ts'
import { drawAngle } from './angleArc.ts'
import type { Backdrop } from './backdrop.ts'
import { drawBeltMarks } from './belt.ts'
import { strokeBody, centre, fillBody } from './body.ts'
import { drawCaptions, placeCaptions } from './captions.ts'
import { drawHandleNumbers, numberBoxes } from './handleNumbers.ts'
import type { ForceDrawing } from './forces.ts'
import { drawHandles } from './handles.ts'
import type { Palette } from './palette.ts'
import { drawOutline, drawWords, physicsOf } from './physicsOutline.ts'
import type { Picture } from './picture.ts'
import { viewOf } from './scenes.ts'
import type { Setting } from './setting.ts'
import { drawSpring } from './spring.ts'
import { drawPush, startRoom } from './start.ts'

/** Draws a picture in its setting, from the back to the front. */
export function paint(
  context: CanvasRenderingContext2D,
  picture: Picture,
  setting: Setting,
  palette: Palette,
  backdrop: Pick<Backdrop, 'draw'>,
  forces?: ForceDrawing,
): void {
  const { layout, projection, handles, numbers } = setting
  const { scene, time } = picture
  const actors = actorsOf(picture, layout, projection)
  const seen = picture.withoutExact ? actors.slice(0, -1) : actors
  const words = backdrop.draw(context, setting, palette, time)
  context.lineJoin = 'round'
  // With the exact block as the last of them there is always one for the spring to hang on.
  const selected = picture.selected === undefined ? undefined : actors[picture.selected]
  const { falls, spring, speed } = viewOf(scene)
  if (speed) drawBeltMarks(context, picture, layout, projection, palette)
  if (spring)
    drawSpring(context, (selected ?? actors[0]!).body, picture, layout, projection, palette)
  for (const actor of actors) drawRunner(context, actor, palette)
  // What has arrows stands in front of the others.
  if (selected && picture.forces) drawRunner(context, selected, palette)
  if (!picture.withoutExact)
    strokeBody(context, actors.at(-1)!.body, { colour: palette.ink, width: 2 })
  const physics = selected && physicsOf(selected, picture, layout, projection)
  if (physics) drawOutline(context, physics, palette)
  drawPush(context, picture, layout, palette)
  const boxes = numberBoxes(context, numbers, layout, palette)
  const room = [...startRoom(picture, layout, projection), ...boxes]
  for (const { id, x, y } of handles) if (id === 'tilt') room.push(around({ x, y }, 12))
  const place = (obstacles: readonly Box[]) =>
    placeCaptions(context, setting, seen, selected, obstacles, palette)
  // Beside a fall arrows give way to captions, elsewhere captions to arrows.
  const column = falls ? place(boxes) : []
  const taken = [...room, ...words, ...column.map(({ box }) => box)]
  const arrows = (selected && forces?.arrows(picture, selected, layout, taken)) ?? []
  for (const arrow of arrows) room.push(arrow.box, ...arrow.room)
  const letters = [...boxes, ...arrows.map(({ box }) => box)]
  drawCaptions(context, falls ? column : place(room), letters, falls, palette)
  if (physics) drawWords(context, physics, layout, falls, palette)
  forces?.draw(context, arrows, palette)
  // An arrow would hide the angle's number.
  if (arrows[0] && words[0]) drawAngle(context, picture, layout, projection, palette)
  drawHandleNumbers(context, numbers, boxes, layout, falls, palette)
  drawHandles(context, handles, picture, palette)
}

/** A runner's block; where its run has gone wrong it fades under a sign of it. */
function drawRunner(context: CanvasRenderingContext2D, actor: Actor, palette: Palette): void {
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
