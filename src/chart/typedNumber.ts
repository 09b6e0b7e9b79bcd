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
