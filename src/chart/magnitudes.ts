import { fixed, metres, plain, superscript } from './numbers.ts'

/** Numbers over many powers of ten, as axes, tables and arithmetic write them. */

const thin = '\u202f'

/** The exponent of the smallest power of ten that is not below a positive value. */
export function decadeAbove(value: number): number {
  return Math.ceil(Math.log10(value) - 1e-9)
}

/** The exponent of the largest power of ten that is not above a positive value. */
export function decadeBelow(value: number): number {
  return Math.floor(Math.log10(value) + 1e-9)
}

/** A distance [m] down to nanometres, as on axes by powers of ten: “0.254 m”, “31.2 nm”, “0 (to rounding)”. */
export function sizeText(value: number): string {
  return value < 1e-6 && value > 0 ? `${plain(value * 1e9)}${thin}nm` : metres(value)
}

/** A distance like `sizeText`, to two digits. */
export function roughSize(value: number): string {
  return sizeText(Number(value.toPrecision(2)))
}

/** A value that should be 0, from thousands down to rounding, in little room: “0.146 m”, “−5.54 mJ”, “12 pm”. */
export function residualText(value: number, unit: string): string {
  const size = Math.abs(value)
  if (size === 0) return 'rounding'
  if (size >= 1000 || Number.isNaN(size)) return `${plain(value)}${thin}${unit}`
  // All values have three decimals where that is enough, so that decimal points align.
  if (size >= 0.01) return `${fixed(value, 3)}${thin}${unit}`
  const steps = size >= 1e-3 ? 1 : size >= 1e-6 ? 2 : size >= 1e-9 ? 3 : 4
  return `${plain(value * 1000 ** steps)}${thin}${'mµnp'[steps - 1]!}${unit}`
}

/** A power of ten of a metre as people say it: “1 m”, “10 cm”, “0.1 mm”, “1 µm”. */
export function decadeText(exponent: number): string {
  if (exponent === -1) return `10${thin}cm`
  if (exponent === -2) return `1${thin}cm`
  if (exponent > 5) return `10${superscript(exponent)}${thin}m`
  if (exponent >= 0) return `${String(10 ** exponent)}${thin}m`
  const group = Math.min(4, Math.ceil(-exponent / 3))
  const rest = exponent + 3 * group
  return rest === 2
    ? `0.1${thin}${prefixes[group - 1]!}m`
    : `${String(10 ** rest)}${thin}${prefixes[group]!}m`
}

/** A power of ten of a metre with at most three digits before the unit: “100 mm”, “1 µm”, “10 km”. */
export function decadeTick(exponent: number): string {
  if (exponent >= 6) return `${plain(10 ** exponent)}${thin}m`
  if (exponent >= 3) return `${10 ** (exponent - 3)}${thin}km`
  const group = Math.max(0, Math.ceil(-exponent / 3))
  return `${Math.round(10 ** (exponent + 3 * group))}${thin}${prefixes[group]!}m`
}

const prefixes = ['', 'm', 'µ', 'n', 'p']

/**
 * A number as it stands in arithmetic: whole if it is short, as 0.1 or −5; else with five digits, of which the last is
 * rounded, as 0.10000 or 1.1102×10⁻¹⁶.
 */
export function numeral(value: number): string {
  if (!Number.isFinite(value)) return 'no number'
  const size = Math.abs(value)
  const short = size.toPrecision(5)
  const [digits, exponent] = size.toExponential(4).split('e') as [string, string]
  const text =
    size !== 0 && (size < 1e-4 || size >= 1e6)
      ? `${digits}×10${superscript(Number(exponent))}`
      : Number(short) === size
        ? String(size)
        : size >= 1e5
          ? String(Math.round(size))
          : short
  return value < 0 ? `−${text}` : text
}
