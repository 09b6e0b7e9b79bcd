/** A canvas's pen, in CSS pixels, on an empty canvas of that size [px]. */
export function cleared(
  canvas: HTMLCanvasElement,
  width: number,
  height: number,
): CanvasRenderingContext2D {
  const pen = canvas.getContext('2d')!
  const columns = Math.round(width * devicePixelRatio)
  const rows = Math.round(height * devicePixelRatio)
  // Setting a size is slow, even where it changes nothing.
  if (canvas.width !== columns) canvas.width = columns
  if (canvas.height !== rows) canvas.height = rows
  pen.setTransform(columns / width, 0, 0, rows / height, 0, 0)
  pen.clearRect(0, 0, width, height)
  return pen
}
