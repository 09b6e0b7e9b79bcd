import { ROUNDING } from '../measure/index.ts'
import { metres, plain } from './numbers.ts'

/** A logarithmic axis: a value's place, and the powers of ten on it. */
export interface LogScale {
  readonly from: number
  readonly to: number
  readonly at: (value: number) => number
  readonly decades: readonly number[]
}

/** An axis from one value to another, laid out between two places [px]. */
export function logScale(from: number, to: number, start: number, end: number): LogScale {
  const low = Math.log10(from)
  const perDecade = (end - start) / (Math.log10(to) - low)
  const first = Math.ceil(low - 1e-9)
  const count = Math.floor(Math.log10(to) + 1e-9) - first + 1
  return {
    from,
    to,
    at: (value) => start + (Math.log10(value) - low) * perDecade,
    decades: Array.from({ length: Math.max(0, count) }, (_, i) => first + i),
  }
}

const prefixes = ['m', 'mm', 'µm', 'nm', 'pm']

/** A power of ten of a metre as people say it: “1 m”, “10 cm”, “0.1 mm”, “1 µm”. */
export function metresText(exponent: number): string {
  if (exponent === -1) return '10\u2009cm'
  if (exponent === -2) return '1\u2009cm'
  if (exponent > 5) return `10${superscript(exponent)}\u2009m`
  if (exponent >= 0) return `${String(10 ** exponent)}\u2009m`
  const group = Math.min(prefixes.length - 1, Math.ceil(-exponent / 3))
  const rest = exponent + 3 * group
  return rest === 2 && group < prefixes.length
    ? `0.1\u2009${prefixes[group - 1]!}`
    : `${String(10 ** rest)}\u2009${prefixes[group]!}`
}

function superscript(exponent: number): string {
  return String(exponent).replace(/[-\d]/g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]!))
}

/** A distance as people say it, down to the nanometres that the axes go to: “0.254 m”, “31.2 nm”, “0 (to rounding)”. */
export function sizeText(value: number): string {
  return value < 1e-6 && value >= ROUNDING ? `${plain(value * 1e9)}\u2009nm` : metres(value)
}

/** The same in two digits, which is as much as can be seen. */
export function roughSize(value: number): string {
  return sizeText(Number(value.toPrecision(2)))
}
