import { actorsOf } from './actors.ts'
import { drawAngle } from './angleArc.ts'
import { strokeBody } from './body.ts'
import { drawCaptions } from './captions.ts'
import { dragged } from './drag.ts'
import { forceArrows } from './forces.ts'
import { drawForces } from './forcesDrawing.ts'
import { drawFigures, figureBoxes, figuresOf } from './figures.ts'
import { drawGround } from './ground.ts'
import { drawHandles, handlesOf } from './handles.ts'
import { around } from './geometry.ts'
import { held, layOut } from './layout.ts'
import type { Layout } from './layout.ts'
import { drawOutline, drawWords, physicsOf } from './physicsOutline.ts'
import { PaletteReader } from './palette.ts'
import type { Palette } from './palette.ts'
import type { Handle, HandleId, Picture } from './picture.ts'
import { drawPost } from './post.ts'
import { Projection } from './projection.ts'
import { drawScaleBar } from './scaleBar.ts'
import { drawRunner } from './signs.ts'
import { drawSpring } from './spring.ts'
import { drawGhost, drawPush, startRoom } from './start.ts'
import { drawStrobe } from './strobe.ts'

/** A canvas that shows pictures. It has no clock and no loop: each call of `draw` draws one picture whole. */
export class Stage {
  /** While true the camera keeps still, so that nothing jumps under a drag; when it is set back to false the next draw fits again. */
  frozen = false

  private readonly context: CanvasRenderingContext2D
  private readonly palette: PaletteReader
  private shown: { picture: Picture; layout: Layout; handles: readonly Handle[] } | undefined

  constructor(private readonly canvas: HTMLCanvasElement) {
    // A canvas that gives no context is a browser out of memory: nothing can be shown then.
    this.context = canvas.getContext('2d')!
    this.palette = new PaletteReader(canvas)
  }

  /** Draws at the canvas's present CSS size and the window's pixel ratio; cheap enough to call on every pointer move. */
  draw(picture: Picture): void {
    const { clientWidth: width, clientHeight: height } = this.canvas
    if (width === 0 || height === 0) return
    this.fitPixels(width, height)
    const layout = this.layoutOf(picture, width, height)
    const handles = handlesOf(picture, layout)
    this.shown = { picture, layout, handles }
    paint(this.context, picture, layout, handles, this.palette.read())
  }

  /** Where the handles stand in the picture drawn last, CSS px. The element puts real, focusable 44 px targets there. */
  get handles(): readonly Handle[] {
    return this.shown?.handles ?? []
  }

  /** The parameter change that dragging a handle to a point (CSS px) means, rounded to a sensible step for the scale on screen. */
  drag(id: HandleId, x: number, y: number): Readonly<Record<string, number>> {
    return this.shown ? dragged(id, { x, y }, this.shown.picture, this.shown.layout) : {}
  }

  private layoutOf(picture: Picture, width: number, height: number): Layout {
    const { shown } = this
    const still =
      this.frozen &&
      shown?.picture.scene === picture.scene &&
      shown.layout.width === width &&
      shown.layout.height === height
    return still ? held(shown.layout, picture) : layOut(picture, width, height)
  }

  private fitPixels(width: number, height: number): void {
    const ratio = window.devicePixelRatio
    const [columns, rows] = [Math.round(width * ratio), Math.round(height * ratio)]
    // Setting a size clears the canvas and is slow, even where it changes nothing.
    if (this.canvas.width !== columns) this.canvas.width = columns
    if (this.canvas.height !== rows) this.canvas.height = rows
    this.context.setTransform(columns / width, 0, 0, rows / height, 0, 0)
  }
}

/** From the back to the front. */
function paint(
  context: CanvasRenderingContext2D,
  picture: Picture,
  layout: Layout,
  handles: readonly Handle[],
  palette: Palette,
): void {
  const { scene, parameters } = picture
  const projection = new Projection(scene, parameters, layout.camera)
  const actors = actorsOf(picture, layout, projection)
  context.fillStyle = palette.sheet
  context.fillRect(0, 0, layout.width, layout.height)
  if (scene.id === 'fall') drawPost(context, picture, layout, projection, palette)
  else {
    drawGround(context, picture, layout, projection, palette)
    drawScaleBar(context, layout, palette)
  }
  if ('angle' in parameters) drawAngle(context, picture, layout, projection, palette)
  drawStrobe(context, picture, layout, projection, palette)
  drawGhost(context, picture, layout, projection, palette)
  // With the exact block as the last of them there is always one for the spring to hang on.
  const selected = picture.selected === undefined ? undefined : actors[picture.selected]
  if (scene.id === 'spring')
    drawSpring(context, (selected ?? actors[0]!).body, layout, projection, palette)
  for (const actor of actors) drawRunner(context, actor, palette)
  // What has arrows stands in front of the others.
  if (selected && picture.forces) drawRunner(context, selected, palette)
  strokeBody(context, actors.at(-1)!.body, { colour: palette.ink, width: 2 })
  const physics = selected && physicsOf(selected, picture, layout, projection)
  if (physics) drawOutline(context, physics, palette)
  drawPush(context, picture, layout, palette)
  const figures = figuresOf(picture, layout, projection)
  const boxes = figureBoxes(context, figures, layout, palette)
  const room = [...startRoom(picture, layout, projection), ...boxes]
  for (const { id, x, y } of handles) if (id === 'tilt') room.push(around({ x, y }, 12))
  const arrows = selected ? forceArrows(picture, selected, layout, room) : []
  for (const arrow of arrows) room.push(arrow.box, ...arrow.room)
  drawCaptions(context, picture, actors, room, layout, projection, palette)
  if (physics) drawWords(context, physics, layout, scene.id === 'fall', palette)
  drawForces(context, arrows, palette)
  drawFigures(context, figures, boxes, layout, scene.id === 'fall', palette)
  drawHandles(context, handles, picture, palette)
}
