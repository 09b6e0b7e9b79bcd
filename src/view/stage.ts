import { penOf, pixelRatio } from '../chart/pen.ts'
import { forgetWidths } from '../chart/text.ts'
import { Backdrop } from './backdrop.ts'
import { dragged } from './drag.ts'
import type { ForceDrawing } from './forces.ts'
import { held, layOut } from './layout.ts'
import type { Layout } from './layout.ts'
import { paint } from './paint.ts'
import { PaletteReader } from './palette.ts'
import type { Palette } from './palette.ts'
import type { Handle, HandleId, Picture } from './picture.ts'
import { viewOf } from './scenes.ts'
import { isSameButTime, settingOf } from './setting.ts'
import type { Setting } from './setting.ts'
import { endOf, rowAt } from './timeline.ts'

/** A canvas that shows pictures. It has no clock and no loop: each call of `draw` draws one picture whole. */
export class Stage {
  /**
   * While true the camera keeps still, so that nothing jumps under a drag; when it is set back to false the next draw
   * fits again.
   */
  frozen = false

  private readonly context: CanvasRenderingContext2D
  private readonly reader: PaletteReader
  private readonly backdrop = new Backdrop()
  private palette: Palette | undefined
  private shown: Setting | undefined
  /** What the setting shown was made under. */
  private made: { readonly frozen: boolean; readonly ratio: number } | undefined
  /** What time changes in the picture, as it was drawn last; undefined where the next is to be drawn in any case. */
  private cacheKey: readonly number[] | undefined

  constructor(private readonly canvas: HTMLCanvasElement) {
    // A canvas that gives no context is a browser out of memory: nothing can be shown then.
    this.context = canvas.getContext('2d')!
    this.reader = new PaletteReader(canvas)
  }

  /**
   * Draws at the canvas's CSS size and at the pixels that it covers. What only the time has changed is quick to draw, and what
   * it has not changed is not drawn.
   *
   * @param forces what draws the picture's forces, once it is loaded
   */
  draw(picture: Picture, forces?: ForceDrawing): void {
    const { frozen, made, shown } = this
    const ratio = pixelRatio(this.canvas)
    const isKept = made?.frozen === frozen && made.ratio === ratio
    if (isKept && shown && isSameButTime(picture, shown.picture)) {
      const before = this.cacheKey
      this.cacheKey = this.cacheKeyOf(picture)
      if (before && this.cacheKey?.every((each, i) => Object.is(each, before[i]))) return
    } else {
      const { clientWidth: width, clientHeight: height } = this.canvas
      if (width === 0 || height === 0) return
      penOf(this.canvas, width, height)
      this.palette = this.reader.read()
      this.shown = settingOf(picture, this.layoutOf(picture, width, height))
      this.made = { frozen, ratio }
      this.cacheKey = undefined
    }
    paint(this.context, picture, this.shown!, this.palette!, this.backdrop, forces)
  }

  /**
   * To be called when the canvas's size, the page's colours or its fonts have changed: asking at every frame is slow.
   */
  refresh(): void {
    this.made = undefined
    forgetWidths()
  }

  /** Where the handles stand in the picture drawn last, CSS px. The element puts real, focusable 44 px targets there. */
  get handles(): readonly Handle[] {
    return this.shown?.handles ?? []
  }

  /**
   * The parameter change that dragging a handle to a point (CSS px) means, rounded to a sensible step for the scale on
   * screen.
   */
  drag(id: HandleId, x: number, y: number): Readonly<Record<string, number>> {
    return this.shown ? dragged(id, { x, y }, this.shown.picture, this.shown.layout) : {}
  }

  private cacheKeyOf(picture: Picture): number[] | undefined {
    // Arrows change with more than that.
    if (picture.forces) return undefined
    return [...cacheKeyAt(picture), this.backdrop.dotsAt(picture.time)]
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
}

/**
 * All that time changes in the blocks of a picture and in a belt, as numbers: at two times with the same numbers they look the same.
 * Forces are not among them.
 */
function cacheKeyAt({ scene, runners, exact, time }: Picture): number[] {
  const numbers = [exact(time, { s: 0, v: 0 }).s, viewOf(scene).speed ? time : 0]
  for (const { trajectory, goal } of runners) {
    const row = rowAt(trajectory, time)
    const end = endOf(trajectory)
    numbers.push(
      ...[trajectory.s[row]!, trajectory.drawnS[row]!, (goal ?? trajectory).drawnS[row]!],
      end && row >= end.row ? 1 : 0,
    )
  }
  return numbers
}
