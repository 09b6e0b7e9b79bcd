/** No canvas is drawn finer than that for a page that enlarges it. */
const FINEST = 4

/** By how much the page scales canvases, by a transform or by `zoom`; 1 where it was not asked. */
const scales = new WeakMap<HTMLCanvasElement, number>()

/** Measures by how much the page scales a canvas: to be called when that may have changed, since it lays the page out. */
export function measureScale(canvas: HTMLCanvasElement): void {
  const { offsetWidth } = canvas
  const { width } = canvas.getBoundingClientRect()
  // Of what is not displayed nothing is known, and a difference of less than a pixel is none.
  const isScaled = offsetWidth > 0 && Math.abs(offsetWidth - width) >= 1
  scales.set(canvas, isScaled ? width / offsetWidth : 1)
}

/** The pixels of the screen that a canvas covers with each of its own. */
export function pixelRatio(canvas: HTMLCanvasElement): number {
  return Math.min(FINEST, (scales.get(canvas) ?? 1) * window.devicePixelRatio)
}

/** A canvas's pen in CSS pixels, on a canvas of that size [px]. What was drawn stays if the size does. */
export function penOf(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D {
  const pen = canvas.getContext('2d')!
  const ratio = pixelRatio(canvas)
  const columns = Math.round(width * ratio)
  const rows = Math.round(height * ratio)
  // Setting a size clears the canvas and is slow, even where it changes nothing.
  if (canvas.width !== columns) canvas.width = columns
  if (canvas.height !== rows) canvas.height = rows
  pen.setTransform(columns / width, 0, 0, rows / height, 0, 0)
  return pen
}

/** The same on an empty canvas. */
export function cleared(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D {
  const pen = penOf(canvas, width, height)
  pen.clearRect(0, 0, width, height)
  return pen
}
