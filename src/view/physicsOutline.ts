import { clamp, moved } from '../chart/geometry.ts'
import { widthOf, write } from '../chart/text.ts'
import { bodyAt } from './actors.ts'
import type { Actor } from './actors.ts'
import { strokeBody } from './body.ts'
import type { DrawnBody } from './body.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'

/** A block as it is drawn, and the one that physics knows: a step ahead of it, or behind it. */
interface Apart {
  readonly drawn: DrawnBody
  readonly physics: DrawnBody
  readonly paletteIndex: number
}

/** Where the physics of a block is, if it can be seen to be elsewhere than where the block is drawn. */
export function physicsOf(
  { runner, row, beyond, body }: Actor,
  picture: Picture,
  layout: Layout,
  projection: Projection,
): Apart | undefined {
  if (!runner || row === undefined || beyond !== 0) return undefined
  const { camera, extent } = layout
  const s = runner.trajectory.s[row]!
  const apart = Math.abs(s - runner.trajectory.drawnS[row]!) * camera.scale
  if (!(apart > 1) || s < extent.from - 1e-9 || s > extent.to + 1e-9) return undefined
  return {
    drawn: body,
    physics: bodyAt(s, picture, layout, projection),
    paletteIndex: runner.paletteIndex,
  }
}

/** The outline of the block that physics knows. */
export function drawOutline(
  context: CanvasRenderingContext2D,
  { physics, paletteIndex }: Apart,
  palette: Palette,
): void {
  const colour = palette.runners[paletteIndex]!.text
  strokeBody(context, physics, { colour, width: 1.5, dash: [3, 3] })
}

/** Says which is which: below the dots of a track, beside a ball. */
export function drawWords(
  context: CanvasRenderingContext2D,
  { drawn, physics, paletteIndex }: Apart,
  { width, lanes, block }: Layout,
  vertical: boolean,
  palette: Palette,
): void {
  context.font = `${width < 480 ? 11 : 12}px ${palette.sans}`
  const word = (text: string, { spot }: DrawnBody): Word => {
    const half = widthOf(context, text) / 2
    const room = 8 + half * Math.abs(spot.out.x) + 5 * Math.abs(spot.out.y)
    const { x, y } = moved(spot, spot.out, vertical ? block + room : -lanes.depth - room)
    return { text, half, x: clamp(x, half + 4, width - half - 4), y }
  }
  const words: [Word, Word] = [word('drawn', drawn), word('physics', physics)]
  const { along } = drawn.spot
  if (Math.abs(along.y) > Math.abs(along.x)) keepApart(words, 'y', 15)
  else keepApart(words, 'x', words[0].half + words[1].half + 8)
  for (const { text, half, x, y } of words) {
    if (vertical) {
      context.fillStyle = palette.sheet
      context.fillRect(x - half - 3, y - 8, 2 * half + 6, 16)
    }
    context.fillStyle = palette.runners[paletteIndex]!.text
    write(context, text, x, y + 4, {
      align: 'center',
      halo: vertical ? palette.sheet : palette.ground,
    })
  }
}

interface Word {
  readonly text: string
  readonly half: number
  x: number
  y: number
}

/** Two words share what they lack of a distance, in their order. */
function keepApart([a, b]: [Word, Word], axis: 'x' | 'y', distance: number): void {
  const difference = b[axis] - a[axis]
  const lack = distance - Math.abs(difference)
  if (lack <= 0) return
  const sign = difference < 0 ? -1 : 1
  a[axis] -= (sign * lack) / 2
  b[axis] += (sign * lack) / 2
}
