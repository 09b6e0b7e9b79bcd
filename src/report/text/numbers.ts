/** Figures for a table: written as on the page, and what is no more than rounding said so. */
import { sizeText } from '../../chart/magnitudes.ts'
import { count, metres, plain, seconds } from '../../chart/numbers.ts'

/** Below this a difference is an accident of rounding [m]. */
const ROUNDING = 1e-11

/** “0.321 m”, “10 nm”, “0 (to rounding)”, “0”; “no number” for null. */
export function inMetres(value: number | null): string {
  const size = Math.abs(value ?? NaN)
  if (size === 0) return '0'
  return size < ROUNDING ? metres(0) : sizeText(size)
}

/** The same of several: those that are 0, exactly or to rounding, are said once. */
export function eachInMetres(values: readonly (number | null)[]): string {
  const small = values.every((value) => value !== null && Math.abs(value) < ROUNDING)
  if (!small) return values.map(inMetres).join(', ')
  return inMetres(Math.max(...values.map((value) => Math.abs(value ?? 0))))
}

/** “5.12 ns”, “12.3 µs”. */
export function nanoseconds(value: number): string {
  return seconds(value * 1e-9)
}

/** “1.2×”, “310×”. */
export function asMultiple(value: number): string {
  return `${plainNumber(value)}×`
}

/** “4”, “0.125”, “1 400”, “3.6 × 10¹³”. */
export function plainNumber(value: number): string {
  return count(plain(value))
}
