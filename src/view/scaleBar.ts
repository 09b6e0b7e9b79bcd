import type { Layout } from './layout.ts'
import { metres } from '../chart/numbers.ts'
import type { Palette } from './palette.ts'
import { roundBelow } from '../chart/round.ts'
import { widthOf, write } from '../chart/text.ts'

/** A bar of a round length, in the ground at the lower right. */
export function drawScaleBar(
  context: CanvasRenderingContext2D,
  { width, height, camera }: Layout,
  palette: Palette,
): void {
  const length = roundBelow((0.28 * width) / camera.scale)
  const label = metres(length)
  context.font = `${width < 480 ? 11 : 12}px ${palette.sans}`
  const right = width - 16 - widthOf(context, label) - 8
  const left = right - length * camera.scale
  const y = height - 15
  context.strokeStyle = context.fillStyle = palette.inkSoft
  context.lineWidth = 1.5
  context.beginPath()
  context.moveTo(left, y - 4)
  context.lineTo(left, y + 4)
  context.moveTo(left, y)
  context.lineTo(right, y)
  context.moveTo(right, y - 4)
  context.lineTo(right, y + 4)
  context.stroke()
  write(context, label, right + 8, y + 4)
}
