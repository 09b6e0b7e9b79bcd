/**
 * What is drawn on a canvas, pixel by pixel.
 *
 * @throws Error, for people, where the browser gives none, or another one
 */
export function pictureOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    if (!canvasesAreRead())
      throw new Error(
        'Nothing is saved: this browser hides from pages what they have drawn, as a protection against tracking. Allow this page to read canvases, or take a screenshot.',
      )
    canvas.toBlob((blob) => {
      if (blob) resolve(blob)
      else reject(new Error('The browser could not make a picture of it.'))
    }, 'image/png')
  })
}

const SIZE = 16

/** Whether pixels come back as they were drawn: protection against fingerprinting returns white, or noise. */
function canvasesAreRead(): boolean {
  const canvas = Object.assign(document.createElement('canvas'), { width: SIZE, height: SIZE })
  const pen = canvas.getContext('2d')!
  // Each pixel has a colour of its own, since noise spares what is all one colour.
  const drawn = pen.createImageData(SIZE, SIZE)
  for (let i = 0; i < drawn.data.length; i += 4)
    drawn.data.set([i % 251, (7 * i) % 241, (13 * i) % 239, 255], i)
  pen.putImageData(drawn, 0, 0)
  const { data } = pen.getImageData(0, 0, SIZE, SIZE)
  return data.every((value, i) => value === drawn.data[i])
}
