/** The finest resolution of a canvas on a page that enlarges it. */
const FINEST = 4

/** The page's scale of each canvas, from transforms or `zoom`; 1 if not measured. */
const scales = new WeakMap<HTMLCanvasElement, number>()

/** Measures the page's scale of a canvas. Call it only when that may have changed: it forces a layout. */
export function measureScale(canvas: HTMLCanvasElement): void {
  const { offsetWidth } = canvas
  const { width } = canvas.getBoundingClientRect()
  // A canvas that is not displayed has no size; ignore differences of less than a pixel.
  const isScaled = offsetWidth > 0 && Math.abs(offsetWidth - width) >= 1
  scales.set(canvas, isScaled ? width / offsetWidth : 1)
}

/** The pixels of the screen that a canvas covers with each of its own. */
export function pixelRatio(canvas: HTMLCanvasElement): number {
  return Math.min(FINEST, (scales.get(canvas) ?? 1) * window.devicePixelRatio)
}

/** A canvas's pen in CSS pixels, on a canvas of that size [px]. The drawing is kept if the size does not change. */
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

/** Like `penOf`, on an emptied canvas. */
export function cleared(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D {
  const pen = penOf(canvas, width, height)
  pen.clearRect(0, 0, width, height)
  return pen
}
