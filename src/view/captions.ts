import { clamp } from '../chart/geometry.ts'
import type { Box } from '../chart/geometry.ts'
import type { Actor } from './actors.ts'
import { boundsOf, centre, top } from './body.ts'
import { captionOf, drawCaption, drawLeader } from './caption.ts'
import type { Caption, Written } from './caption.ts'
import { placeColumn, placeLabels } from './labels.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Projection } from './projection.ts'
import { viewOf } from './scenes.ts'
import type { Setting } from './setting.ts'

/** Where every actor's caption stands, none over another, over a block or over the `obstacles`. */
export function placeCaptions(
  context: CanvasRenderingContext2D,
  { picture, layout, projection, sky }: Setting,
  actors: readonly Actor[],
  selected: Actor | undefined,
  obstacles: readonly Box[],
  palette: Palette,
): Written[] {
  context.font = `500 ${layout.row - 5}px ${palette.sans}`
  const { font } = context
  const captions = actors.map((actor) => captionOf(context, font, actor, picture, layout))
  const vertical = viewOf(picture.scene).falls
  captions.sort(inOrder(captions, projection, vertical))
  if (vertical) return column(captions, obstacles, layout)
  const poles = captions.map(({ actor, width, lean }) => ({
    foot: top(actor.body),
    width,
    // Many stand closer.
    height: layout.row - (actors.length > 5 ? 3 : 0),
    lean,
    sure: !actor.runner || actor === selected,
  }))
  const bodies = actors.map(({ body }) => boundsOf(body))
  const boxes = placeLabels(poles, [...bodies, ...obstacles], sky, layout.width)
  return captions.flatMap((caption, i) => {
    const box = boxes[i]
    return box ? { caption, box } : []
  })
}

/** Writes them. No pole goes through a caption, nor through other `letters`. */
export function drawCaptions(
  context: CanvasRenderingContext2D,
  captions: readonly Written[],
  letters: readonly Box[],
  vertical: boolean,
  palette: Palette,
): void {
  const upwards = [...letters, ...captions.map(({ box }) => box)].sort((a, b) => b.top - a.top)
  // The poles of high labels first: where several blocks share one, each length of it has its label's colour.
  for (const written of [...captions].reverse()) {
    // One that had to go aside has none: its line would cross the others.
    if (!written.box.aside) drawLeader(context, written, upwards, vertical, palette)
  }
  for (const written of captions) drawCaption(context, written, palette)
}

/** By where the runs end: the same at every moment, and so that poles don't cross labels where they end. */
function inOrder(captions: readonly Caption[], projection: Projection, vertical: boolean) {
  const ends = captions.map(({ actor }) => projection.at(actor.last))
  const falling = ends.reduce((sum, { descent }) => sum + descent, 0) > 0.05 * ends.length
  const sign = falling && !vertical ? -1 : 1
  const key = new Map(
    captions.map((caption, i) => [caption, vertical ? ends[i]!.y : sign * ends[i]!.x]),
  )
  const given = [...captions]
  return (a: Caption, b: Caption) => {
    const difference = key.get(a)! - key.get(b)!
    // What differs by rounding stands in the order of the list.
    return Math.abs(difference) > 0.01 ? difference : given.indexOf(a) - given.indexOf(b)
  }
}

/** Beside a fall, to the right of the arrow and its number; where the canvas is too narrow, above or below these. */
function column(
  captions: readonly Caption[],
  obstacles: readonly Box[],
  { width, height, row }: Layout,
): Written[] {
  const widest = Math.max(...captions.map((caption) => caption.width))
  const ball = boundsOf(captions[0]!.actor.body)
  const left = clamp(ball.right + 84, 0, Math.max(0, width - widest - 8))
  let [low, high] = [4, height - 4]
  for (const { right, top, bottom } of obstacles) {
    if (right < left) continue
    if (top > height - bottom) high = top
    else low = bottom
  }
  const middles = placeColumn(
    captions.map(({ actor }) => centre(actor.body).y),
    row,
    low,
    high,
  )
  return middles.map((y, i) => {
    const caption = captions[i]!
    const right = left + caption.width
    return { caption, box: { left, top: y - row / 2, right, bottom: y + row / 2, aside: false } }
  })
}
