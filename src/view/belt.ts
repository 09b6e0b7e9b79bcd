import { clamp } from '../chart/geometry.ts'
import type { Point } from '../chart/geometry.ts'
import { speed as speedText } from '../chart/numbers.ts'
import { write } from '../chart/text.ts'
import { drawArrow } from './arrows.ts'
import { drawnEnds } from './ground.ts'
import type { Layout } from './layout.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import type { Projection } from './projection.ts'
import { viewOf } from './scenes.ts'
import { beltDepth } from './sizes.ts'

/** Marks closer than this can't be told apart [px]. */
const CLOSEST = 34
/** A mark moves by less than this part of the way to the next while a screen shows one picture. */
const PART = 0.25
const REFRESH = 1 / 60
const MARK = 5

/** A belt around two rollers: level, and as long as the track is drawn [px]. */
interface Belt {
  readonly left: number
  /** Of its straight parts. */
  readonly length: number
  readonly top: number
  /** Of the rollers. */
  readonly radius: number
}

function beltOf(layout: Layout, projection: Projection): Belt {
  const { from, to } = drawnEnds(layout)
  const radius = beltDepth(layout.lanes) / 2
  const [a, b] = [projection.at(from), projection.at(to)]
  // The post of the spring stands before it.
  const left = Math.min(a.x, b.x) + 8 + radius
  return { left, length: Math.max(a.x, b.x) - radius - left, top: a.y, radius }
}

/** The belt, which takes the place of the ground, and how fast it moves. */
export function drawBelt(
  context: CanvasRenderingContext2D,
  { scene, parameters }: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  const { left, length, top, radius } = beltOf(layout, projection)
  context.beginPath()
  context.roundRect(left - radius, top, length + 2 * radius, 2 * radius, radius)
  context.fillStyle = palette.ground
  context.fill()
  context.strokeStyle = palette.ink
  context.lineWidth = 1.5
  context.stroke()
  context.lineWidth = 1
  for (const x of [left, left + length]) {
    context.beginPath()
    context.arc(x, top + radius, 3, 0, 2 * Math.PI)
    context.stroke()
  }

  const v = viewOf(scene).speed!(parameters)
  const y = top + 2 * radius + 18
  const reach = v === 0 ? 0 : clamp(18 + layout.arrow * Math.abs(v), 24, 0.3 * layout.width)
  const ends: [Point, Point] = [
    { x: left, y },
    { x: left + reach, y },
  ]
  const [tail, tip] = v * scene.facing > 0 ? ends : (ends.reverse() as [Point, Point])
  if (v !== 0) drawArrow(context, tail, tip, { colour: palette.inkSoft, width: 2, head: 10 })
  context.font = `${layout.width < 480 ? 11 : 12}px ${palette.sans}`
  context.fillStyle = palette.inkSoft
  write(context, `belt ${speedText(Math.abs(v))}`, left + (reach && reach + 8), y + 4)
}

/** Marks on the belt, where they are at the picture's time. */
export function drawBeltMarks(
  context: CanvasRenderingContext2D,
  { scene, parameters, time }: Picture,
  layout: Layout,
  projection: Projection,
  palette: Palette,
): void {
  const belt = beltOf(layout, projection)
  const around = 2 * belt.length + 2 * Math.PI * belt.radius
  const pace = scene.facing * viewOf(scene).speed!(parameters) * layout.camera.scale
  const gap = Math.max(CLOSEST, (Math.abs(pace) * REFRESH) / PART)
  const count = Math.max(3, Math.floor(around / gap))
  context.strokeStyle = palette.ink
  context.lineWidth = 1.5
  context.beginPath()
  for (let i = 0; i < count; i++) {
    const way = (i / count) * around + pace * time
    const { x, y, inX, inY } = pointOn(belt, way - Math.floor(way / around) * around)
    context.moveTo(x, y)
    context.lineTo(x + MARK * inX, y + MARK * inY)
  }
  context.stroke()
}

/** The point so far along the belt from where its upper part begins, clockwise, and the direction to its inside. */
function pointOn({ left, length, top, radius }: Belt, way: number) {
  const half = Math.PI * radius
  if (way < length) return { x: left + way, y: top, inX: 0, inY: 1 }
  if (way < length + half) return onRoller(left + length, top, radius, (way - length) / radius)
  const back = way - length - half
  if (back < length) return { x: left + length - back, y: top + 2 * radius, inX: 0, inY: -1 }
  return onRoller(left, top, radius, Math.PI + (back - length) / radius)
}

function onRoller(x: number, top: number, radius: number, turn: number) {
  const [sin, cos] = [Math.sin(turn), Math.cos(turn)]
  return { x: x + radius * sin, y: top + radius - radius * cos, inX: -sin, inY: cos }
}
