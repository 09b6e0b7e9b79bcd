import { integrators } from '../../physics/index.ts'
import type { Integrator, TriedStep } from '../../physics/index.ts'
import { say } from './said.ts'
import type { Said } from './said.ts'

/** A line of a formula with the numbers of a step. */
export interface WrittenLine {
  /** In letters, from the integrator's own formula. */
  readonly formula: string
  /** Its right side in numbers. */
  readonly numbers: Said
  /** What it gave in the step that ran. */
  readonly result: number
  readonly unit: string
  /** Where the line is an equation for its own left side: how that was solved. */
  readonly solved?: Said
}

/** The lines of a step, or of one of the steps that it is made of. */
export interface WrittenStep {
  readonly heading: string
  /** [s] */
  readonly dt: number
  readonly lines: readonly WrittenLine[]
}

/** A step as its integrator's formula, as the numbers put into it, and as what came out. */
export function written(method: Integrator, tried: TriedStep): WrittenStep[] {
  if (method.id !== 'yoshida4')
    return [{ heading: 'Δt', dt: tried.dt, lines: linesOf(method, tried) }]
  const verlet = integrators.find(({ id }) => id === 'velocity-verlet')!
  return subSteps(tried).map((part, i) => ({
    heading: `Verlet by ${i === 1 ? 'w₀' : 'w₁'}Δt`,
    dt: part.dt,
    lines: linesOf(verlet, part),
  }))
}

/**
 * The formula lists force evaluations in the order in which they are made. In the formula,
 * s′ and v′ are the state at the end of the step; any other velocity is the one at which the next evaluation was made.
 */
function linesOf({ formula }: Integrator, tried: TriedStep): WrittenLine[] {
  const { from, to, dt, evaluations, reused } = tried
  const known: Record<string, number> = { s: from.s, v: from.v, Δt: dt, 's′': to.s, 'v′': to.v }
  const made = [...(reused === undefined ? [] : [{ ...from, a: reused }]), ...evaluations]
  let next = 0
  const lines = formula.flatMap((line) => line.split(/,\s{2}/))
  return lines.map((line) => {
    const [target, expression] = line.split(' = ') as [string, string]
    // A velocity that its own line asks for was guessed: the last guess is the one that it kept.
    const isGuessed = target[0] === 'v' && !(target in known) && expression.includes(target)
    if (isGuessed) {
      next = made.length - 1
      known[target] = made[next]!.v
    }
    const numbers = substituted(
      expression,
      (name) => known[name]!,
      () => made[next++]!.a,
    )
    if (/^a\([^()]*\)$/u.test(expression)) known[target] = made[next++]!.a
    else known[target] ??= made[next]![target[0] as 's' | 'v']
    const unit = { s: 'm', v: 'm/s', a: 'm/s²' }[target[0] as 's' | 'v' | 'a']
    const written = { formula: line, numbers, result: known[target], unit }
    return isGuessed ? { ...written, solved: guesses(tried, target) } : written
  })
}

/** The equation of the implicit midpoint method, whose mean velocity `v` is guessed until its two sides agree. */
function guesses({ from, dt, evaluations }: TriedStep, name: string): Said {
  const { v, a } = evaluations[evaluations.length - 1]!
  const times = evaluations.length === 1 ? 'once' : `${evaluations.length} times`
  return say`${name} stands on both sides: guessed ${times}; now they differ by ${from.v + 0.5 * dt * a - v} m/s.`
}

/** What a formula is made of: a look at the forces, a name, a literal, a sign. */
const token = /a\(([^()]*)\)|(v\u0304|Δt|[sva](?:[′½]|[₁-₉][₀₁]?)?)|(√?\d+|½)|([()+−/,²])/gu

/**
 * An expression of an integrator's formula with numbers in place of its letters. Products, which formulas write by
 * standing letters side by side, get their ×, and negative numbers the brackets they need.
 *
 * @param value what a letter stands for
 * @param call what the next a(…) gave; an expression that is nothing else shows what stands in its brackets
 */
function substituted(
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

const OUTER = 1 / (2 - Math.cbrt(2))
const INNER = -Math.cbrt(2) * OUTER

/**
 * The three Verlet steps that a step of Yoshida's method is made of. Only their ends were looked at, so the velocity
 * between two of them is worked out from the accelerations at both ends.
 */
function subSteps({ dt, from, to, slip, reused, evaluations }: TriedStep): TriedStep[] {
  const made = [...(reused === undefined ? [] : [{ a: reused }]), ...evaluations]
  // Where the force ignores v, each step begins with the look that the one before ended with.
  const shared = made.length === 4
  let begin = from
  return [OUTER, INNER, OUTER].map((part, i) => {
    const length = part * dt
    const first = made[shared ? i : 2 * i]!
    const last = evaluations[evaluations.length - (shared ? 3 - i : 5 - 2 * i)]!
    const again = shared && (i > 0 || reused !== undefined)
    const end = i === 2 ? to : { s: last.s, v: begin.v + 0.5 * (first.a + last.a) * length }
    const step: TriedStep = {
      ...{ dt: length, from: begin, to: end, slip },
      reused: again ? first.a : undefined,
      evaluations: again ? [last] : [first as typeof last, last],
    }
    begin = end
    return step
  })
}
