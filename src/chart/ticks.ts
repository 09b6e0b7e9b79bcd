/** Numbers that people would choose for the ticks of an axis: 1, 2 or 5 times a power of ten. */

/** The largest round number that is not above a positive limit. */
export function roundBelow(limit: number): number {
  const power = 10 ** Math.floor(Math.log10(limit))
  const digit = limit / power
  // A limit that is itself round may come out a bit below itself.
  const slack = 1 + 1e-9
  return clean((digit * slack >= 5 ? 5 : digit * slack >= 2 ? 2 : 1) * power)
}

/** The smallest round number that is not less than a positive limit. */
export function roundAbove(limit: number): number {
  const power = 10 ** Math.floor(Math.log10(limit))
  const digit = limit / power
  const slack = 1 - 1e-9
  return clean(
    (digit * slack <= 1 ? 1 : digit * slack <= 2 ? 2 : digit * slack <= 5 ? 5 : 10) * power,
  )
}

/** The multiple of a round step that is nearest to a value, as its shortest decimal: 0.3, not 0.30000000000000004. */
export function toStep(value: number, step: number): number {
  return clean(Math.round(value / step) * step) + 0
}

/** The decimals that the multiples of a round step need. */
export function decimalsOf(step: number): number {
  return Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
}

function clean(value: number): number {
  return Number(value.toPrecision(12))
}
