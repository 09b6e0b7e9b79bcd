/** A canvas's pen in CSS pixels, on a canvas of that size [px]. What was drawn stays if the size does. */
export function penOf(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D {
  const pen = canvas.getContext('2d')!
  const { devicePixelRatio } = window
  const columns = Math.round(width * devicePixelRatio)
  const rows = Math.round(height * devicePixelRatio)
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
