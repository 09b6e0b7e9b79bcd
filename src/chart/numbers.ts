/**
 * Numbers as people read them: a true minus sign, never more digits than can be seen, thin spaces before units.
 */

const minus = '−'
const thin = '\u202f'

/** “0.41 m”, “1.2 mm”; of a difference without its rounding, “0 (to rounding)”. */
export function metres(value: number): string {
  const size = Math.abs(value)
  if (!Number.isFinite(value)) return 'no number'
  if (size === 0) return '0 (to rounding)'
  if (size < 1e-3) return withUnit(value * 1e6, 'µm')
  if (size < 0.01) return withUnit(value * 1e3, 'mm')
  return withUnit(value, 'm')
}

/** A distance [m] to two digits: “0.048 m”, “3.2 mm”. */
export function roughMetres(value: number): string {
  return metres(Number(value.toPrecision(2)))
}

/** A distance [m] in words and large type: to the centimetre, or where that says nothing to two digits. */
export function lengthText(length: number): string {
  if (!Number.isFinite(length)) return 'without bound'
  return length >= 0.01 && length < 1000 ? place(length) : roughMetres(length)
}

/**
 * A distance along the track, with the same number of decimals while it changes, so that it keeps its width: “1.47 m”,
 * and “1.470 m” or “0.31 mm” where a difference as small as `visible` [m] shows in the picture.
 */
export function place(value: number, visible = 0.01): string {
  if (!Number.isFinite(value)) return 'no number'
  if (Math.abs(value) >= 1000) return withUnit(value, 'm')
  if (visible > 5e-4) return `${fixed(value, visible < 0.004 ? 3 : 2)}${thin}m`
  return `${fixed(value * 1e3, visible > 5e-5 ? 1 : visible > 5e-6 ? 2 : 3)}${thin}mm`
}

/** “5 m/s”, “−2.5 m/s”. */
export function speed(value: number): string {
  return withUnit(value, 'm/s')
}

/** “15°”, “12.5°”. */
export function degrees(value: number): string {
  return `${plain(value)}°`
}

/** “0.70 s”, “12.3 ms”, “12 ns”. */
export function seconds(value: number): string {
  const size = Math.abs(value)
  if (size === 0 || size >= 0.1) return `${fixed(value, 2)}${thin}s`
  if (size >= 1e-4) return withUnit(value * 1e3, 'ms')
  if (size >= 1e-6) return withUnit(value * 1e6, 'µs')
  return withUnit(value * 1e9, 'ns')
}

/** A whole number with its digits in threes: “12 345”. */
export function count(value: number | string): string {
  return String(value).replace(/\B(?=(\d{3})+$)/g, thin)
}

/** Every digit, for a title attribute: as it can be pasted back. */
export function raw(value: number): string {
  return String(value)
}

/** With that many decimals, and without a minus where all digits are zero. */
export function fixed(value: number, decimals: number): string {
  const text = Math.abs(value).toFixed(decimals)
  return value < 0 && Number(text) !== 0 ? minus + text : text
}

/** Three significant digits at most, without idle zeros; very large ones as a power of ten. */
export function plain(value: number): string {
  if (!Number.isFinite(value)) return 'no number'
  const sign = value < 0 ? minus : ''
  const size = Math.abs(value)
  if (size === 0) return '0'
  if (size >= 1e6 || size < 1e-4) {
    const [digits, exponent] = size.toExponential(1).split('e') as [string, string]
    return `${sign}${Number(digits)}${thin}×${thin}10${superscript(Number(exponent))}`
  }
  return sign + String(size >= 100 ? Math.round(size) : Number(size.toPrecision(3)))
}

/** From ten thousand on a whole number stands in threes. */
function withUnit(value: number, unit: string): string {
  const number = plain(value)
  return `${/^−?\d{5,}$/.test(number) ? count(number) : number}${thin}${unit}`
}

/** “⁻¹²”. */
export function superscript(exponent: number): string {
  return String(exponent).replace(/[-\d]/g, (c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[Number(c)]!))
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
  return text.replaceAll('-', minus)
}
