const decimal = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?$/i

/** The number that a text stands for: a decimal, `1e-3`, or a fraction as `1/60`; undefined where it is none. */
export function readNumber(text: string): number | undefined {
  const parts = text
    .replaceAll('−', '-')
    .split('/')
    .map((part) => part.trim())
  if (parts.length > 2 || !parts.every((part) => decimal.test(part))) return undefined
  const [numerator, denominator = '1'] = parts
  return Number(numerator) / Number(denominator)
}

/** The shortest text that `readNumber` turns into the very same number: `1/60` instead of seventeen digits. */
export function writeNumber(value: number): string {
  const text = String(value)
  const inverse = Math.round(1 / value)
  const isFraction = text.length > 6 && Math.abs(inverse) < 100000 && 1 / inverse === value
  return isFraction ? `${inverse < 0 ? '-' : ''}1/${Math.abs(inverse)}` : text
}

/** A number as a field shows it while nobody types there: with a true minus, and no more than six digits. */
export function shownNumber(value: number): string {
  const whole = writeNumber(value)
  const text = whole.length > 9 ? String(Number(value.toPrecision(6))) : whole
  return text.replaceAll('-', '−')
}
