/** Words with numbers between them. The numbers stay numbers, so that they can be rounded for reading and shown raw. */
export type Said = readonly (string | number)[]

/** A sentence as a template: numbers in it are kept as such, what was said already is taken in. */
export function say(words: TemplateStringsArray, ...values: (string | number | Said)[]): Said {
  return words.flatMap((word, i) => [word, ...([values[i] ?? []].flat() as Said)])
}

/** The same as plain text, with each number as `numeral` writes it. */
export function textOf(said: Said): string {
  return said.map((each) => (typeof each === 'number' ? numeral(each) : each)).join('')
}

/**
 * A number as it stands in arithmetic, with a true minus: whole if it is short, as 0.1 or −5; else with five digits, of
 * which the last is rounded, as 0.10000 or 1.1102×10⁻¹⁶.
 */
export function numeral(value: number): string {
  if (!Number.isFinite(value)) return 'no number'
  const size = Math.abs(value)
  const short = size.toPrecision(5)
  const [digits, exponent] = size.toExponential(4).split('e') as [string, string]
  const text =
    size !== 0 && (size < 1e-4 || size >= 1e6)
      ? `${digits}×10${exponent.replace(/[+\-\d]/g, superscript)}`
      : Number(short) === size
        ? String(size)
        : size >= 1e5
          ? String(Math.round(size))
          : short
  return value < 0 ? `−${text}` : text
}

/** “1 step”, “6 steps”. */
export function count(number: number, what: string): string {
  return `${number} ${what}${number === 1 ? '' : 's'}`
}

function superscript(letter: string): string {
  return letter === '-'
    ? '⁻'
    : (['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][Number(letter)] ?? '')
}
