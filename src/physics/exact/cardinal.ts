/**
 * f(x)/x from f(x) and x, for the sine and its relatives, which are x near 0: 1 there. Formulas in these tend to their
 * limits (no drag, no spring) by themselves, where a quotient of small numbers would lose its digits.
 */
export function cardinal(value: number, x: number): number {
  return x === 0 ? 1 : value / x
}
