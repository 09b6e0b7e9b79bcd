import type { Said } from './said.ts'

/** What a formula is made of: a look at the forces, a name, a literal, a sign. */
const token = /a\(([^()]*)\)|(v\u0304|Δt|[sva](?:[′½]|[₁-₉][₀₁]?)?)|(√?\d+|½)|([()+−/,²])/gu

/**
 * An expression of an integrator's formula with numbers in place of its letters. Products, which formulas write by
 * standing letters side by side, get their ×, and negative numbers the brackets they need.
 *
 * @param value what a letter stands for
 * @param call what the next a(…) gave; an expression that is nothing else shows what stands in its brackets
 */
export function substituted(
  expression: string,
  value: (name: string) => number,
  call: () => number,
): Said {
  const whole = /^a\(([^()]*)\)$/u.exec(expression)
  if (whole) return ['a(', ...substituted(whole[1]!, value, call), ')']
  const said: (string | number)[] = []
  let before = ''
  for (const [text, look, name, literal] of expression.matchAll(token)) {
    const isValue = look !== undefined || name !== undefined
    const beginsOperand = isValue || literal !== undefined || text === '('
    if (beginsOperand && before !== '' && !/^[(+−/,]$/u.test(before)) said.push(' × ')
    if (isValue) {
      const number = look === undefined ? value(name!) : call()
      const bracket = (number < 0 || Object.is(number, -0)) && !['', '(', ','].includes(before)
      said.push(...(bracket ? ['(', number, ')'] : [number]))
    } else said.push(/[+−]/u.test(text) ? ` ${text} ` : text === ',' ? ', ' : text)
    before = text
  }
  return said
}
