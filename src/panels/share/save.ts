/** Hands a file to the reader, as a download. */
export function save(content: Blob, name: string): void {
  const link = document.createElement('a')
  link.href = URL.createObjectURL(content)
  link.download = name
  link.click()
  // Some browsers take the content a little later.
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000)
}

/** What is drawn on a canvas, pixel by pixel. */
export function pictureOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob)
      else reject(new Error('The browser could not make a picture of it.'))
    }, 'image/png')
  })
}
