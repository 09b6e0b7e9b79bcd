import { clamp } from '../chart/geometry.ts'
import type { Box, Point } from '../chart/geometry.ts'
import { degrees } from '../chart/numbers.ts'
import { widthOf, write } from '../chart/text.ts'
import { drawnEnds } from './ground.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'
import { viewOf } from './scenes.ts'
import { slackBox } from './spring.ts'

/**
 * The slope's angle at its foot: a dashed horizontal, an arc and the value. Answers with the room of the words there.
 */
export function drawAngle(
  context: CanvasRenderingContext2D,
  picture: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): Box[] {
  const { scene, parameters } = picture
  const angle = (parameters.angle! * Math.PI) / 180
  const vertex = vertexOf(picture, layout, projection)
  const { spring, climbs, bend } = viewOf(scene)
  // Uphill is against growing s, but on a track that climbs first.
  const side = climbs ? scene.facing : -scene.facing
  const { lanes, width } = layout
  const { from, to } = drawnEnds(layout)
  const slope = ((bend?.(parameters).from ?? to) - from) * layout.camera.scale
  // Far enough out for the number to have room between the horizontal and the dots under the track.
  const room = lanes.depth + 22
  const radius = clamp(room / Math.tan(angle), 60, Math.max(60, 0.45 * slope))

  const label = degrees(parameters.angle!)
  context.font = `${width < 480 ? 14 : 17}px ${palette.sans}`
  const labelWidth = widthOf(context, label)
  const wedge = (radius + 8) * Math.tan(angle)
  // Where there is none, under the horizontal and the dots.
  const y = wedge >= room - 1 ? vertex.y - 7 : vertex.y + 17 + Math.max(0, lanes.depth - wedge)
  const words: Box[] = []
  let near = vertex.x + side * (radius + 9)
  if (spring) {
    // Beside the word that stands there, where they would cross.
    const word = slackBox(context, layout, projection, palette)
    words.push(word)
    const far = near + side * labelWidth
    const isBeside = Math.min(near, far) > word.right + 6 || Math.max(near, far) < word.left - 6
    if (!isBeside && y > word.top - 6 && y - 17 < word.bottom)
      near = side > 0 ? word.right + 10 : word.left - 10
  }
  const left = side > 0 ? near : Math.max(near - labelWidth, 6)
  const right = left + labelWidth
  context.strokeStyle = palette.inkSoft
  context.lineWidth = 1
  context.setLineDash([4, 4])
  context.beginPath()
  context.moveTo(vertex.x, vertex.y)
  context.lineTo(side > 0 ? right + 15 : left - 15, vertex.y)
  context.stroke()
  context.setLineDash([])
  context.beginPath()
  if (side > 0) context.arc(vertex.x, vertex.y, radius, -angle, 0)
  else context.arc(vertex.x, vertex.y, radius, Math.PI, Math.PI + angle)
  context.stroke()

  context.fillStyle = palette.ink
  write(context, label, left, y, { halo: palette.ground })
  return [...words, { left, top: y - 14, right, bottom: y }]
}

/** Where the line of the slope meets the level ground. */
function vertexOf(picture: Picture, layout: Layout, projection: Projection): Point {
  const { scene, parameters } = picture
  const { climbs, bend: bendOf } = viewOf(scene)
  const { from, to } = drawnEnds(layout)
  if (climbs) return projection.at(from)
  const bend = bendOf?.(parameters)
  if (!bend) return projection.at(to)
  // Both tangents of an arc are as long, from where it begins and ends to where they cross.
  const { x, y } = projection.at(bend.to)
  const tangent = bend.radius * Math.tan((parameters.angle! * Math.PI) / 360)
  return { x: x - tangent * layout.camera.scale, y }
}
