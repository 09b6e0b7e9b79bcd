import type { Actor } from './actors.ts'
import { boundsOf, centre, top } from './body.ts'
import { captionOf } from './caption.ts'
import type { Caption } from './caption.ts'
import { drawCaption, drawLeader } from './captionDrawing.ts'
import { clamp } from './geometry.ts'
import type { Box } from './geometry.ts'
import { placeColumn, placeLabels } from './labels.ts'
import type { Placed } from './labels.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'

/** Writes every actor's caption, none over another, over a block or over the `obstacles`. */
export function drawCaptions(
  context: CanvasRenderingContext2D,
  picture: Picture,
  actors: readonly Actor[],
  obstacles: readonly Box[],
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  context.font = `500 ${layout.row - 5}px ${palette.sans}`
  const { font } = context
  const captions = actors.map((actor) => captionOf(context, font, actor, picture, layout))
  const vertical = picture.scene.id === 'fall'
  captions.sort(inOrder(captions, projection, vertical))
  const boxes = vertical
    ? column(captions, layout)
    : stacks(captions, [...actors.map(({ body }) => boundsOf(body)), ...obstacles], layout)
  // The poles of high labels first: where several blocks share one, each length of it has its label's colour.
  for (const i of [...captions.keys()].reverse()) {
    const box = boxes[i]
    // One that had to go aside has none: its line would cross the others.
    if (box && !box.aside) drawLeader(context, captions[i]!, box, vertical, palette)
  }
  captions.forEach((caption, i) => {
    const box = boxes[i]
    if (box) drawCaption(context, caption, box, captions, palette)
  })
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

/** On poles. Where there isn't room for all in one stack, the exact block's label is sure of its place in it. */
function stacks(
  captions: readonly Caption[],
  obstacles: readonly Box[],
  layout: Layout,
): (Placed | undefined)[] {
  const placed = (order: readonly Caption[]) => {
    const poles = order.map(({ actor, width, lean }) => ({
      foot: top(actor.body),
      width,
      height: layout.row,
      lean,
    }))
    const labels = placeLabels(poles, obstacles, layout.width)
    return captions.map((caption) => labels[order.indexOf(caption)])
  }
  const labels = placed(captions)
  if (labels.every((label) => label && !label.aside)) return labels
  const exact = captions.filter(({ actor }) => !actor.runner)
  return placed([...exact, ...captions.filter(({ actor }) => actor.runner)])
}

/** Beside a fall, to the right of the arrow and its figure. */
function column(captions: readonly Caption[], { width, height, row }: Layout): Placed[] {
  const widest = Math.max(...captions.map((caption) => caption.width))
  const ball = boundsOf(captions[0]!.actor.body)
  const left = clamp(ball.right + 84, 0, Math.max(0, width - widest - 8))
  const middles = placeColumn(
    captions.map(({ actor }) => centre(actor.body).y),
    row,
    4,
    height - 4,
  )
  return middles.map((y, i) => ({
    left,
    top: y - row / 2,
    right: left + captions[i]!.width,
    bottom: y + row / 2,
    aside: false,
  }))
}
