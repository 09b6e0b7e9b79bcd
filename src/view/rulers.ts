import { fixed, metres } from '../chart/numbers.ts'
import { widthOf, write } from '../chart/text.ts'
import { decimalsOf, roundAbove, roundBelow } from '../chart/ticks.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'

/** What a fall has instead of a track: a post beside it with a scale of metres, which counts from the start. */
export function drawPost(
  context: CanvasRenderingContext2D,
  { parameters }: Picture,
  { width, height, camera, lanes }: Layout,
  projection: Projection,
  palette: Palette,
): void {
  const { x } = projection.at(0)
  const left = x - lanes.depth - 18
  context.fillStyle = palette.ground
  context.fillRect(left, 0, x - left, height)
  context.strokeStyle = palette.ink
  context.lineWidth = 1.5
  line(context, x, 0, x, height)

  const step = roundAbove(44 / camera.scale)
  const start = parameters.position!
  const zero = projection.at(start).y
  const decimals = decimalsOf(step)
  context.strokeStyle = context.fillStyle = palette.inkSoft
  context.lineWidth = 1
  context.font = `${width < 480 ? 11 : 12}px ${palette.sans}`
  line(context, left, 0, left, height)
  const pixels = (step * camera.scale) / 5
  for (let i = Math.ceil(-zero / pixels); i * pixels + zero < height; i++) {
    const y = zero + i * pixels
    const whole = i % 5 === 0
    line(context, left, y, left + (whole ? 9 : 4), y)
    // Half a number at the edge could not be read.
    if (whole && y > 9 && y < height - 9) {
      const unit = i === 0 ? ' m' : ''
      write(context, fixed((i / 5) * step, decimals) + unit, left - 7, y + 4, { align: 'right' })
    }
  }
}

function line(
  context: CanvasRenderingContext2D,
  x1: number,
  y1: number,
  x2: number,
  y2: number,
): void {
  context.beginPath()
  context.moveTo(x1, y1)
  context.lineTo(x2, y2)
  context.stroke()
}

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
