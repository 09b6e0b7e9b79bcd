/** Figures for a table: three significant digits, units that fit, a power of ten where nothing else does. */

/** Below this a difference is an accident of rounding [m]. */
const ROUNDING = 1e-11

/** “0.32 m”, “53 mm”, “10 nm”, “0 (to rounding)”, “0”. */
export function inMetres(value: number | null): string {
  if (value === null) return 'no number'
  const size = Math.abs(value)
  if (size === 0) return '0'
  if (size < ROUNDING) return '0 (to rounding)'
  if (size < 0.999e-6) return `${digits(size * 1e9)} nm`
  if (size < 0.999e-3) return `${digits(size * 1e6)} µm`
  if (size < 0.1) return `${digits(size * 1e3)} mm`
  return `${digits(size)} m`
}

/** The same of several: those that are 0, exactly or to rounding, are said once. */
export function eachInMetres(values: readonly (number | null)[]): string {
  const small = values.every((value) => value !== null && Math.abs(value) < ROUNDING)
  if (!small) return values.map(inMetres).join(', ')
  return inMetres(Math.max(...values.map((value) => Math.abs(value ?? 0))))
}

/** “5.1 ns”, “12 µs”, “1.6 ms”. */
export function nanoseconds(value: number): string {
  if (value < 1000) return `${digits(value)} ns`
  return value < 1e6 ? `${digits(value / 1000)} µs` : `${digits(value / 1e6)} ms`
}

/** “1.2×”, “310×”. */
export function asMultiple(value: number): string {
  return `${plainNumber(value)}×`
}

/** “4”, “0.125”, “1 400”, “3.6 × 10¹³”. */
export function plainNumber(value: number): string {
  const size = Math.abs(value)
  if (size >= 1e6 || (size > 0 && size < 1e-3)) return power(value)
  return digits(value).replace(/\B(?=(\d{3})+$)/g, '\u202f')
}

function power(value: number): string {
  const [factor, exponent] = value.toExponential(1).split('e') as [string, string]
  const raised = exponent.replace(/[-+\d]/g, (c) =>
    c === '+' ? '' : c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]!,
  )
  return `${Number(factor)} × 10${raised}`
}

function digits(value: number): string {
  const size = Math.abs(value)
  if (size >= 100) return String(Math.round(value))
  return String(Number(value.toPrecision(size >= 10 ? 3 : 2)))
}
