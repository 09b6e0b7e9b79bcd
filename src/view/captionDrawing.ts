import { centre, top } from './body.ts'
import { MARK, partsOf } from './caption.ts'
import type { Caption } from './caption.ts'
import type { Box } from '../chart/geometry.ts'
import type { Placed } from './labels.ts'
import { markOf } from './marks.ts'
import type { Palette } from './palette.ts'
import { write } from '../chart/text.ts'

/** A caption, and where it is written. */
export interface Written {
  readonly caption: Caption
  readonly box: Placed
}

function colours({ actor: { runner } }: Caption, palette: Palette): { fill: string; text: string } {
  return runner ? palette.runners[runner.look]! : { fill: palette.ink, text: palette.ink }
}

/** The line from a block to its label; it is broken where there are `letters`. */
export function drawLeader(
  context: CanvasRenderingContext2D,
  { caption, box }: Written,
  letters: readonly Box[],
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
    const side = x + body.size / 2
    context.moveTo(side, y)
    context.lineTo(Math.max(box.left - 18, side), middle)
    context.lineTo(box.left - 5, middle)
  } else {
    const { x, y } = top(body)
    context.moveTo(x, y)
    // A pole stands beside its label, or under it where the canvas's edge has pushed the label over it.
    const end = x > box.left - 3 && x < box.right + 3 ? box.bottom : box.top + 3
    for (const { left, right, top, bottom } of letters) {
      if (x < left - 2 || x > right + 2 || top > y || bottom <= end) continue
      context.lineTo(x, Math.min(bottom, y))
      context.moveTo(x, Math.max(top, end))
    }
    context.lineTo(x, end)
  }
  context.stroke()
}

/** The mark, the name and the rest. */
export function drawCaption(
  context: CanvasRenderingContext2D,
  { caption, box }: Written,
  palette: Palette,
): void {
  const { actor, font, text, time } = caption
  const { fill, text: colour } = colours(caption, palette)
  const baseline = box.bottom - 5
  const { name: left, flag } = partsOf(caption, box)
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
  const mark = actor.runner ? MARK : 0
  write(context, text, left + mark, baseline, { halo: palette.sheet, font })
  if (actor.end?.kind !== 'at-rest') return
  drawFlag(context, flag, baseline, colour)
  if (time) write(context, time, flag + 10, baseline, { halo: palette.sheet, font })
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
