import { integrators } from '../../physics/index.ts'
import type { Integrator, TriedStep } from '../../physics/index.ts'
import { say } from './said.ts'
import type { Said } from './said.ts'
import { substituted } from './substituted.ts'
import { subSteps } from './subSteps.ts'

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
 * Looks at the forces are in the formula in the order in which they were made. What the formula calls s′ and v′ is where
 * the step ended; any other velocity that it names is the one that the next look was made at.
 */
function linesOf({ formula }: Integrator, tried: TriedStep): WrittenLine[] {
  const { from, to, dt, evaluations, reused } = tried
  const known: Record<string, number> = { s: from.s, v: from.v, Δt: dt, 's′': to.s, 'v′': to.v }
  const looks = [...(reused === undefined ? [] : [{ ...from, a: reused }]), ...evaluations]
  let next = 0
  const lines = formula.flatMap((line) => line.split(/,\s{2}/))
  return lines.map((line) => {
    const [target, expression] = line.split(' = ') as [string, string]
    // A velocity that its own line asks for was guessed: the last guess is the one that it kept.
    const isGuessed = target[0] === 'v' && !(target in known) && expression.includes(target)
    if (isGuessed) {
      next = looks.length - 1
      known[target] = looks[next]!.v
    }
    const numbers = substituted(
      expression,
      (name) => known[name]!,
      () => looks[next++]!.a,
    )
    if (/^a\([^()]*\)$/u.test(expression)) known[target] = looks[next++]!.a
    else known[target] ??= looks[next]![target[0] as 's' | 'v']
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
