/** The formulas that the page shows of a method, read and worked out: they are the step that it takes. */
import { describe, expect, it } from 'vitest'
import { integrators } from '../../src/physics/index.ts'
import type { Integrator } from '../../src/physics/index.ts'
import { bareMotion } from './bareMotion.ts'

type Numbers = Record<string, number>

/** A pull that depends on s and v in a crooked way. */
const pull = (s: number, v: number) => Math.sin(1.3 * s) - 0.4 * v * v + 0.7

/** The value of a formula's right side: sums, products written side by side, a(s, v), ½, and roots of whole numbers. */
function value(text: string, known: Numbers): number {
  const parts = text.match(/a\(|[a-z]′?[₀-₉½]*|Δt²?|√\d+|½|\d+|[()+−/,]/g)!
  if (parts.join('') !== text.replaceAll(' ', '')) throw new Error(`No sign of a formula: ${text}`)
  let at = 0
  const operand = (): number => {
    const part = parts[at++]!
    if (part === 'a(' || part === '(') {
      const first = sum()
      const isCall = parts[at++] === ','
      const inner = isCall ? pull(first, sum()) : first
      if (isCall) at++
      return inner
    }
    if (part.startsWith('√')) return Math.sqrt(Number(part.slice(1)))
    if (part === '½') return 0.5
    const number = /^\d/.test(part) ? Number(part) : known[part]
    if (number === undefined) throw new Error(`${part} in ${text}`)
    return number
  }
  const product = (): number => {
    let result = operand()
    for (let next = parts[at]; next !== undefined && !/^[),+−]$/.test(next); next = parts[at])
      if (next === '/') {
        at++
        result /= operand()
      } else result *= operand()
    return result
  }
  const sum = (): number => {
    let result = parts[at] === '−' ? 0 : product()
    while (parts[at] === '+' || parts[at] === '−')
      result += parts[at++] === '+' ? product() : -product()
    return result
  }
  return sum()
}

/** The state after a step by the formulas. */
function byFormula({ formula }: Integrator, s: number, v: number, dt: number): Numbers {
  const known: Numbers = { s, v, Δt: dt, 'Δt²': dt * dt }
  for (const line of formula)
    for (const statement of line.split(/,\s{2,}/)) {
      const [name, right] = statement.split(' = ') as [string, string]
      known[name] = value(right, known)
    }
  return known
}

// Yoshida's is told in words, and the implicit one is an equation to be solved.
const told: readonly Integrator[] = integrators.filter(
  ({ id }) => id !== 'yoshida4' && id !== 'implicit-midpoint',
)

describe.each(told)('the formulas of $id', (method) => {
  it('are the step that it takes', () => {
    const motion = bareMotion(pull, { s: 0.4, v: 1.1, dt: 0.3 })
    method.step(motion)
    const { 's′': s, 'v′': v } = byFormula(method, 0.4, 1.1, 0.3)
    expect(motion.s).toBeCloseTo(s!, 13)
    expect(motion.v).toBeCloseTo(v!, 13)
  })

  it('name stages by numbers set low', () => {
    for (const line of method.formula) expect(line).not.toMatch(/[sva]\d|undefined|NaN/)
  })
})

describe('the formulas of eleven stages', () => {
  const { formula } = integrators.find(({ id }) => id === 'rk8')!

  it('leave out a factor of 1 and brackets around one term, and have one sign between two terms', () => {
    expect(formula.slice(0, 4)).toEqual([
      'a₁ = a(s, v)',
      'v₂ = v + a₁ Δt/2',
      's₂ = s + v Δt/2',
      'a₂ = a(s₂, v₂)',
    ])
    expect(formula[4]).toBe('v₃ = v + (a₁ + a₂) Δt/4')
    expect(formula[8]).toBe('s₄ = s + (14 v − (7 + 3√21) v₂ + (42 + 10√21) v₃) Δt/98')
    expect(formula[10]).toBe('v₅ = v + ((33 + 3√21) a₁ + (72 + 16√21) a₃ + (21 − √21) a₄) Δt/252')
  })

  it('are three lines for each stage after the first, and two for the step', () => {
    expect(formula).toHaveLength(1 + 3 * 10 + 2)
  })
})
