/**
 * f(x)/x from f(x) and x, for functions like the sine that are ≈ x near 0: 1 there. Formulas in these tend to their
 * limits (no drag, no spring) without losing digits in a quotient of small numbers.
 */
export function cardinal(value: number, x: number): number {
  return x === 0 ? 1 : value / x
}
