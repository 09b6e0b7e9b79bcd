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

/** How else a unit is written, and how many of what is written make one of it. */
const spellings: Readonly<Record<string, Readonly<Record<string, number>>>> = {
  s: { s: 1, sec: 1, seconds: 1, ms: 1e3, µs: 1e6, μs: 1e6, us: 1e6, min: 1 / 60 },
  m: { m: 1, cm: 100, mm: 1e3, km: 1e-3 },
  'm/s': { 'm/s': 1, 'km/h': 3.6 },
  'm/s²': { 'm/s²': 1, 'm/s2': 1, 'm/s^2': 1 },
  '°': { '°': 1, deg: 1, degrees: 1 },
  fps: { fps: 1, hz: 1 },
  kg: { kg: 1, g: 1e3 },
}

/**
 * The number that a reader typed into a field of that unit: as `readNumber`, and with a decimal comma, with the unit after
 * it or with another unit of the same quantity, as “12,5°” or “16.7 ms” in seconds. Undefined where it is none.
 */
export function readTyped(text: string, unit: string, sign = decimalSign): number | undefined {
  if (isAmbiguous(text, sign)) return undefined
  const typed = text.trim()
  const known = spellings[unit] ?? (unit ? { [unit.toLowerCase()]: 1 } : {})
  const spelled = Object.keys(known)
    .filter((each) => typed.toLowerCase().endsWith(each))
    .sort((a, b) => b.length - a.length)[0]
  const number = spelled === undefined ? typed : typed.slice(0, -spelled.length)
  const value = readNumber(number.includes('.') ? number : number.replace(/,(?=\d)/g, '.'))
  return value === undefined || spelled === undefined ? value : value / known[spelled]!
}

/** The decimal sign of the browser’s language. */
export const decimalSign = new Intl.NumberFormat()
  .formatToParts(0.5)
  .find(({ type }) => type === 'decimal')!.value

/** A number as the reader would type it: with a decimal comma where the browser’s language has one. */
export function asTyped(number: string, sign = decimalSign): string {
  return sign === ',' ? number.replace('.', ',') : number
}

/** Whether a comma may stand for thousands as well as for decimals: “1,234”. */
export function isAmbiguous(text: string, sign = decimalSign): boolean {
  if (sign === ',') return false
  return /^\s*[-+−]?[1-9]\d{0,2},\d{3}(?!\d)/.test(text)
}

/** The items of a list that was typed: with blanks, semicolons or commas between them, where these are not decimal. */
export function typedItems(text: string): string[] {
  // A unit belongs to the number before it.
  const joined = text.trim().replace(/(\d)\s+(?=(?:s|ms|µs|μs|us)(?:[\s,;]|$))/g, '$1')
  const isDecimal = /\d,\d/.test(joined) && /[\s;]/.test(joined) && !/,\s|\./.test(joined)
  return joined.split(isDecimal ? /[\s;]+/ : /[\s,;]+/).filter(Boolean)
}
