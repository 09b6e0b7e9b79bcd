import { plainBackdrop } from './backdrop.ts'
import { layOut } from './layout.ts'
import { paint } from './paint.ts'
import type { Palette } from './palette.ts'
import type { Picture } from './picture.ts'
import { isSameButTime, settingOf } from './setting.ts'
import type { Setting } from './setting.ts'

/** By the runners of a picture: what only the time has changed is not laid out again. */
const kept = new WeakMap<Picture['runners'], Setting>()

/** Draws a picture whole on a context of a size [px]. */
export function drawScene(
  context: CanvasRenderingContext2D,
  picture: Picture,
  { width, height }: { readonly width: number; readonly height: number },
  palette: Palette,
): void {
  let setting = kept.get(picture.runners)
  if (
    !setting ||
    setting.layout.width !== width ||
    setting.layout.height !== height ||
    !isSameButTime(picture, setting.picture)
  )
    kept.set(picture.runners, (setting = settingOf(picture, layOut(picture, width, height))))
  paint(context, picture, setting, palette, plainBackdrop)
}
