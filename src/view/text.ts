/** Words and figures on a canvas. Digits are all set as wide as a 0: a figure that changes does not jitter. */

export type Align = 'left' | 'center' | 'right'

/** As wide as `write` sets it, in the context's font. */
export function widthOf(context: CanvasRenderingContext2D, text: string): number {
  return context.measureText(text.replace(/\d/g, '0')).width
}

/** Writes on the baseline y, in the context's font and fill. With a `halo`, on a rim of that colour. */
export function write(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  { align = 'left', halo }: { align?: Align; halo?: string } = {},
): void {
  const width = widthOf(context, text)
  const left = align === 'left' ? x : align === 'center' ? x - width / 2 : x - width
  context.textAlign = 'left'
  context.textBaseline = 'alphabetic'
  if (halo) {
    context.save()
    context.strokeStyle = halo
    context.lineWidth = 4
    context.lineJoin = 'round'
    each(context, text, left, (part, at) => context.strokeText(part, at, y))
    context.restore()
  }
  each(context, text, left, (part, at) => context.fillText(part, at, y))
}

function each(
  context: CanvasRenderingContext2D,
  text: string,
  left: number,
  draw: (part: string, x: number) => void,
): void {
  const digit = context.measureText('0').width
  let x = left
  for (const part of text.split(/(\d)/)) {
    if (!part) continue
    const width = context.measureText(part).width
    if (/^\d$/.test(part)) {
      draw(part, x + (digit - width) / 2)
      x += digit
    } else {
      draw(part, x)
      x += width
    }
  }
}
