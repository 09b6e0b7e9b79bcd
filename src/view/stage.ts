import { actorsOf } from './actors.ts'
import { Backdrop } from './backdrop.ts'
import { strokeBody } from './body.ts'
import { drawCaptions } from './captions.ts'
import { dragged } from './drag.ts'
import { drawFigures, figureBoxes } from './figures.ts'
import { forceArrows } from './forces.ts'
import { drawForces } from './forcesDrawing.ts'
import { around } from './geometry.ts'
import { drawHandles } from './handles.ts'
import { held, layOut } from './layout.ts'
import type { Layout } from './layout.ts'
import { PaletteReader } from './palette.ts'
import type { Palette } from './palette.ts'
import { drawOutline, drawWords, physicsOf } from './physicsOutline.ts'
import type { Handle, HandleId, Picture } from './picture.ts'
import { isSameButTime, settingOf } from './setting.ts'
import type { Setting } from './setting.ts'
import { drawRunner } from './signs.ts'
import { drawSpring } from './spring.ts'
import { drawPush, startRoom } from './start.ts'
import { forgetWidths } from './text.ts'

/** A canvas that shows pictures. It has no clock and no loop: each call of `draw` draws one picture whole. */
export class Stage {
  /** While true the camera keeps still, so that nothing jumps under a drag; when it is set back to false the next draw fits again. */
  frozen = false

  private readonly context: CanvasRenderingContext2D
  private readonly reader: PaletteReader
  private readonly backdrop = new Backdrop()
  private palette: Palette | undefined
  private shown: Setting | undefined
  /** What the setting shown was made under. */
  private made: { readonly frozen: boolean; readonly ratio: number } | undefined

  constructor(private readonly canvas: HTMLCanvasElement) {
    // A canvas that gives no context is a browser out of memory: nothing can be shown then.
    this.context = canvas.getContext('2d')!
    this.reader = new PaletteReader(canvas)
  }

  /** Draws at the canvas's CSS size and the window's pixel ratio. What only the time has changed is quick to draw. */
  draw(picture: Picture): void {
    const { frozen, made, shown } = this
    const ratio = window.devicePixelRatio
    const isKept = made?.frozen === frozen && made.ratio === ratio
    if (!isKept || !shown || !isSameButTime(picture, shown.picture)) {
      const { clientWidth: width, clientHeight: height } = this.canvas
      if (width === 0 || height === 0) return
      this.fitPixels(width, height, ratio)
      this.palette = this.reader.read()
      this.shown = settingOf(picture, this.layoutOf(picture, width, height))
      this.made = { frozen, ratio }
    }
    paint(this.context, picture, this.shown!, this.palette!, this.backdrop)
  }

  /** To be called when the canvas's size, the page's colours or its fonts have changed: asking at every frame is slow. */
  refresh(): void {
    this.made = undefined
    forgetWidths()
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

  private fitPixels(width: number, height: number, ratio: number): void {
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
  setting: Setting,
  palette: Palette,
  backdrop: Backdrop,
): void {
  const { layout, projection, handles, figures } = setting
  const { scene, time } = picture
  const actors = actorsOf(picture, layout, projection)
  backdrop.draw(context, setting, palette, time)
  context.lineJoin = 'round'
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
