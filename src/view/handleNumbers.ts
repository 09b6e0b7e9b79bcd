import { around, clamp, moved } from '../chart/geometry.ts'
import type { Box, Point } from '../chart/geometry.ts'
import { degrees, place, speed } from '../chart/numbers.ts'
import { widthOf, write } from '../chart/text.ts'
import { handleAt } from './handles.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection, Spot } from './projection.ts'
import { viewOf } from './scenes.ts'

/** A number next to a handle. */
export interface HandleNumber {
  readonly text: string
  /** Where its middle stands. */
  readonly at: Point
  readonly held: boolean
}

/** The numbers next to handles: the speed always, the others while their handle is held or pointed at. */
export function handleNumbersOf(
  picture: Picture,
  layout: Layout,
  projection: Projection,
): HandleNumber[] {
  const { scene, parameters, held, lit } = picture
  const { falls } = viewOf(scene)
  const spot = projection.at(parameters.position!)
  const numbers: HandleNumber[] = []
  const v = parameters.speed!
  if (v !== 0 || held === 'push' || lit === 'push') {
    const tip = handleAt('push', picture, layout)
    const at = falls ? moved(tip, spot.out, 40) : moved(tip, clear(spot, 24), 1)
    numbers.push({ text: speed(Math.abs(v)), at, held: held === 'push' })
  }
  if (held === 'place') {
    const middle = handleAt('place', picture, layout)
    const at = moved(middle, clear(spot, layout.block / 2 + 20), 1)
    numbers.push({
      text: place(parameters.position!, 2 / layout.camera.scale),
      at: falls ? moved(middle, spot.out, layout.block / 2 + 34) : at,
      held: true,
    })
  }
  if (held === 'tilt' && 'angle' in parameters) {
    const at = moved(handleAt('tilt', picture, layout), { x: 0, y: -1 }, 28)
    numbers.push({ text: degrees(parameters.angle!), at, held: true })
  }
  return numbers
}

/** A distance away from the ground, more sideways than upwards: a number is wider than it is high. */
function clear({ out }: Spot, distance: number): Point {
  return { x: 1.9 * out.x * distance, y: out.y * distance }
}

/** The room that each takes, on the canvas. */
export function numberBoxes(
  context: CanvasRenderingContext2D,
  numbers: readonly HandleNumber[],
  { width, height }: Layout,
  palette: Palette,
): Box[] {
  return numbers.map(({ text, at, held }) => {
    setFont(context, held, width, palette)
    const half = widthOf(context, text) / 2 + 7
    const x = clamp(at.x, half + 4, width - half - 4)
    return around({ x, y: clamp(at.y, 16, height - 16) }, half, 12)
  })
}

/** Writes each into its box. */
export function drawHandleNumbers(
  context: CanvasRenderingContext2D,
  numbers: readonly HandleNumber[],
  boxes: readonly Box[],
  { width }: Layout,
  vertical: boolean,
  palette: Palette,
): void {
  numbers.forEach(({ text, held }, i) => {
    const { left, right, top, bottom } = boxes[i]!
    if (held) {
      context.beginPath()
      context.roundRect(left, top, right - left, bottom - top, 6)
      context.fillStyle = palette.accent
      context.fill()
    }
    // Lines from balls to their labels pass here.
    if (vertical && !held) {
      context.fillStyle = palette.sheet
      context.fillRect(left + 4, top + 2, right - left - 8, bottom - top - 4)
    }
    setFont(context, held, width, palette)
    context.fillStyle = held ? palette.sheet : palette.accentText
    write(context, text, (left + right) / 2, (top + bottom) / 2 + 5, {
      align: 'center',
      ...(held ? {} : { halo: palette.sheet }),
    })
  })
}

function setFont(
  context: CanvasRenderingContext2D,
  held: boolean,
  width: number,
  { sans, serif }: Palette,
): void {
  const size = width < 480 ? 14 : 16
  context.font = held ? `600 ${size - 1}px ${sans}` : `italic ${size + 1}px ${serif}`
}
