import { centre, top } from './body.ts'
import { MARK } from './caption.ts'
import type { Caption } from './caption.ts'
import { clamp } from './geometry.ts'
import type { Box, Point } from './geometry.ts'
import { markOf } from './marks.ts'
import type { Palette } from './palette.ts'
import { write } from './text.ts'

function colours({ actor: { runner } }: Caption, palette: Palette): { fill: string; text: string } {
  return runner ? palette.runners[runner.look]! : { fill: palette.ink, text: palette.ink }
}

/** The line from a block to its label. */
export function drawLeader(
  context: CanvasRenderingContext2D,
  caption: Caption,
  box: Box,
  vertical: boolean,
  palette: Palette,
): void {
  const { body } = caption.actor
  context.strokeStyle = colours(caption, palette).text
  context.lineWidth = 1
  context.beginPath()
  if (vertical) {
    const middle = (box.top + box.bottom) / 2
    const { x, y } = centre(body)
    context.moveTo(x + body.size / 2, y)
    context.lineTo(box.left - 18, middle)
    context.lineTo(box.left - 5, middle)
  } else {
    const foot: Point = top(body)
    context.moveTo(foot.x, foot.y)
    // A pole stands beside its label, or under it where the canvas's edge has pushed the label over it.
    if (foot.x > box.left - 3 && foot.x < box.right + 3) context.lineTo(foot.x, box.bottom)
    else context.lineTo(foot.x, box.top + 3)
  }
  context.stroke()
}

/** The mark, the name and the rest. `all`: every caption, for poles that go up behind this one. */
export function drawCaption(
  context: CanvasRenderingContext2D,
  caption: Caption,
  box: Box,
  all: readonly Caption[],
  palette: Palette,
): void {
  const { actor, font, text, time, textWidth, lean, pole } = caption
  const { fill, text: colour } = colours(caption, palette)
  const baseline = box.bottom - 5
  const mark = actor.runner ? MARK : 0
  const nameWidth = mark + textWidth
  // The name keeps to its pole, also where the canvas's edge has pushed the label; the flag takes what is left.
  const near = lean > 0.5 ? pole - nameWidth - 6 : box.left
  const left = clamp(near, box.left, box.right - nameWidth)
  if (crossed(caption, left, nameWidth, box, all)) {
    context.globalAlpha = 0.9
    context.fillStyle = palette.sheet
    context.fillRect(left - 1, box.top + 1, nameWidth + 2, box.bottom - box.top - 2)
    context.globalAlpha = 1
  }
  if (actor.runner) {
    const path = markOf(actor.runner.look, 4.6)
    context.save()
    context.translate(left + 5, baseline - 4.5)
    context.strokeStyle = palette.sheet
    context.lineWidth = 3
    context.stroke(path)
    context.fillStyle = fill
    context.fill(path)
    context.restore()
  }
  context.fillStyle = colour
  write(context, text, left + mark, baseline, { halo: palette.sheet, font })
  if (actor.end?.kind !== 'at-rest') return
  const roomy = left - box.left > caption.flag - 1
  const beyond = lean > 0.5 ? Math.max(left + nameWidth, pole) : left + nameWidth
  const flag = roomy ? box.left + 2 : beyond + 6
  drawFlag(context, flag, baseline, colour)
  if (time) write(context, time, flag + 10, baseline, { halo: palette.sheet, font })
}

/** Whether another's pole goes up behind a name: letters with a line through them can't be read. */
function crossed(
  caption: Caption,
  left: number,
  width: number,
  box: Box,
  all: readonly Caption[],
): boolean {
  return all.some(
    ({ actor, pole }) =>
      actor !== caption.actor &&
      pole > left - 2 &&
      pole < left + width + 2 &&
      top(actor.body).y > box.bottom,
  )
}

function drawFlag(
  context: CanvasRenderingContext2D,
  x: number,
  baseline: number,
  colour: string,
): void {
  context.strokeStyle = context.fillStyle = colour
  context.lineWidth = 1.2
  context.beginPath()
  context.moveTo(x, baseline + 1)
  context.lineTo(x, baseline - 10)
  context.stroke()
  context.beginPath()
  context.moveTo(x, baseline - 10)
  context.lineTo(x + 7, baseline - 7)
  context.lineTo(x, baseline - 4)
  context.fill()
}
