import table from './advances.json'

/** How wide each letter is, in thousandths of its size, by face. */
const faces = new Map(
  Object.entries(table).map(([face, widths]) => [
    face,
    new Map(
      Object.entries(widths).flatMap(([width, letters]) =>
        [...letters].map((letter) => [letter, Number(width)] as const),
      ),
    ),
  ]),
)

/** What a canvas's `font` says: `italic 500 13px var(--sans)`. */
interface Font {
  readonly italic: boolean
  readonly weight: number
  readonly size: number
  readonly family: 'sans' | 'serif'
}

function fontOf(font: string): Font {
  const size = Number(/([\d.]+)px/.exec(font)?.[1] ?? 10)
  const weight = Number(/\b([1-9]00)\b/.exec(font)?.[1] ?? (font.includes('bold') ? 600 : 400))
  const family = font.includes('--serif') ? 'serif' : 'sans'
  return { italic: font.includes('italic'), weight, size, family }
}

/** The width of a text in the page's own fonts, digits all as wide as a 0, without kerning [px]. */
export function textWidth(text: string, font: string): number {
  const { italic, weight, size, family } = fontOf(font)
  const face =
    family === 'serif'
      ? faces.get(italic ? 'serif italic 400' : weight < 550 ? 'serif 400' : 'serif 600')!
      : faces.get(`sans ${Math.min(700, Math.max(400, weight))}`)!
  let sum = 0
  // What the fonts lack comes from another one, about as wide as a digit.
  for (const letter of text) sum += face.get(letter) ?? face.get('0')!
  return (sum * size) / 1000
}
