/** A number as an index under the line: 12 as ₁₂. */
export function ordinal(index: number): string {
  return String(index).replace(/\d/g, (digit) => '₀₁₂₃₄₅₆₇₈₉'[Number(digit)]!)
}
