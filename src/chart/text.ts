/** Words and numbers on a canvas. Digits are all set as wide as a 0, so that a number that changes does not jitter. */

export type Align = 'left' | 'center' | 'right'

/** A text as it is set in a font. */
interface SetText {
  readonly width: number
  /** What is drawn in one piece, and how far from the left [px]. */
  readonly parts: readonly { readonly text: string; readonly x: number }[]
}

/** By font and text: measuring takes longer than drawing. */
const settings = new Map<string, SetText>()
const MOST_SETTINGS = 2000

/** Call this when a font has loaded: the widths of texts may have changed. */
export function forgetWidths(): void {
  settings.clear()
}

/** The width of a text as `write` draws it [px]. Pass `font` if known: reading it from a context is slow. */
export function widthOf(
  context: CanvasRenderingContext2D,
  text: string,
  font = context.font,
): number {
  return settingOf(context, text, font).width
}

/** Writes on the baseline y, in the context's font and fill. With a `halo`, on a rim of that colour. */
export function write(
  context: CanvasRenderingContext2D,
  text: string,
  x: number,
  y: number,
  {
    align = 'left',
    halo,
    font = context.font,
  }: { align?: Align; halo?: string; font?: string } = {},
): void {
  const { width, parts } = settingOf(context, text, font)
  const left = align === 'left' ? x : align === 'center' ? x - width / 2 : x - width
  context.textAlign = 'left'
  context.textBaseline = 'alphabetic'
  if (halo) {
    context.save()
    context.strokeStyle = halo
    context.lineWidth = 4
    context.lineJoin = 'round'
    for (const part of parts) context.strokeText(part.text, left + part.x, y)
    context.restore()
  }
  for (const part of parts) context.fillText(part.text, left + part.x, y)
}

function settingOf(context: CanvasRenderingContext2D, text: string, font: string): SetText {
  const key = `${font} ${text}`
  let setting = settings.get(key)
  if (!setting) {
    if (settings.size >= MOST_SETTINGS) settings.clear()
    settings.set(key, (setting = set(context, text)))
  }
  return setting
}

function set(context: CanvasRenderingContext2D, text: string): SetText {
  const measured = (part: string) => context.measureText(part).width
  const width = measured(text.replace(/\d/g, '0'))
  // A font whose digits are all as wide does it by itself.
  if (measured(text) === width) return { width, parts: [{ text, x: 0 }] }
  const digit = measured('0')
  let x = 0
  const parts = text.split(/(\d)/).filter(Boolean)
  return {
    width,
    parts: parts.map((part) => {
      const wide = measured(part)
      const isDigit = /^\d$/.test(part)
      const at = isDigit ? x + (digit - wide) / 2 : x
      x += isDigit ? digit : wide
      return { text: part, x: at }
    }),
  }
}
