import { drawArrow } from './arrows.ts'
import type { ForceArrow } from './forces.ts'
import type { Point } from '../chart/geometry.ts'
import type { Palette } from './palette.ts'
import { write } from '../chart/text.ts'

/** Draws the arrows on a block, gravity's parts dashed, and the letters at the tips. */
export function drawForces(
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
