import type { Box } from '../chart/geometry.ts'
import { fixed, metres } from '../chart/numbers.ts'
import { widthOf, write } from '../chart/text.ts'
import { decimalsOf, roundAbove, roundBelow } from '../chart/ticks.ts'
import { drawAngle } from './angleArc.ts'
import { drawBelt } from './belt.ts'
import { drawGround } from './ground.ts'
import type { Palette } from './palette.ts'
import { viewOf } from './scenes.ts'
import type { Setting } from './setting.ts'
import { drawGhost } from './start.ts'
import { batchesOf, countDots, drawBatch, drawFaint, drawLatest, lanesOf } from './strobe.ts'
import type { Batch, Lane } from './strobe.ts'
import { rowAt } from './timeline.ts'
import type { Layout } from './layout.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'

/**
 * What stands behind the blocks, on a canvas that is kept: the track, and the dots of the frames shown so far. While
 * time goes forward only new dots are added to it.
 */
export class Backdrop {
  private readonly canvas = document.createElement('canvas')
  private readonly context = this.canvas.getContext('2d', { alpha: false })!
  private setting: Setting | undefined
  private lanes: readonly Lane[] = []
  private batches: readonly Batch[] = []
  private words: Box[] = []
  /** How many of the batches have been drawn. */
  private drawn = 0

  /** How many dots it shows at a time, in the setting that it was last drawn in. */
  dotsAt(time: number): number {
    return countDots(this.lanes, time)
  }

  /** Draws it as it is at a time, over all of a context's canvas. Answers with the room of the words in its ground. */
  draw(target: CanvasRenderingContext2D, setting: Setting, palette: Palette, time: number): Box[] {
    const last = this.batches[this.drawn - 1]
    if (setting !== this.setting) {
      this.setting = setting
      this.lanes = lanesOf(setting.picture, setting.layout, setting.projection, palette)
      this.batches = batchesOf(this.lanes)
      this.clear(target, setting, palette)
    } else if (last && !isShown(last, time)) this.clear(target, setting, palette)
    for (let next; (next = this.batches[this.drawn]) && isShown(next, time); this.drawn++)
      drawBatch(this.context, next)
    target.save()
    target.resetTransform()
    target.drawImage(this.canvas, 0, 0)
    target.restore()
    drawLatest(target, this.lanes, time)
    return this.words
  }

  /** Draws all that is there before the first frame. */
  private clear(target: CanvasRenderingContext2D, setting: Setting, palette: Palette): void {
    const { picture, layout, projection } = setting
    const { canvas, context } = this
    const { width, height } = target.canvas
    if (canvas.width !== width) canvas.width = width
    if (canvas.height !== height) canvas.height = height
    context.setTransform(target.getTransform())
    this.drawn = 0
    this.words = drawScenery(context, setting, palette)
    drawFaint(context, this.lanes)
    drawGhost(context, picture, layout, projection, palette)
  }
}

/** The track, and what it is measured with. */
function drawScenery(
  context: CanvasRenderingContext2D,
  { picture, layout, projection }: Setting,
  palette: Palette,
): Box[] {
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, layout.width, layout.height)
  const { falls, speed } = viewOf(picture.scene)
  if (falls) drawPost(context, picture, layout, projection, palette)
  else {
    const draw = speed ? drawBelt : drawGround
    draw(context, picture, layout, projection, palette)
    drawScaleBar(context, layout, palette)
  }
  return 'angle' in picture.parameters
    ? drawAngle(context, picture, layout, projection, palette)
    : []
}

/** Draws a backdrop straight on a context, without keeping anything of it. */
export const plainBackdrop: Pick<Backdrop, 'draw'> = {
  draw(context, setting, palette, time) {
    const { picture, layout, projection } = setting
    const lanes = lanesOf(picture, layout, projection, palette)
    const words = drawScenery(context, setting, palette)
    drawFaint(context, lanes)
    drawGhost(context, picture, layout, projection, palette)
    for (const batch of batchesOf(lanes)) if (isShown(batch, time)) drawBatch(context, batch)
    drawLatest(context, lanes, time)
    return words
  },
}

function isShown({ lane: { trajectory }, last }: Batch, time: number): boolean {
  return last <= rowAt(trajectory, time)
}

/** What a fall has instead of a track: a post beside it with a scale of metres, which counts from the start. */
function drawPost(
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
function drawScaleBar(
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
