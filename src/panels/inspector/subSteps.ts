import type { TriedStep } from '../../physics/index.ts'

const OUTER = 1 / (2 - Math.cbrt(2))
const INNER = -Math.cbrt(2) * OUTER

/**
 * The three Verlet steps that a step of Yoshida's method is made of. Only their ends were looked at, so the velocity
 * between two of them is worked out from the accelerations at both ends.
 */
export function subSteps({ dt, from, to, slip, reused, evaluations }: TriedStep): TriedStep[] {
  const looks = [...(reused === undefined ? [] : [{ a: reused }]), ...evaluations]
  // Where the force ignores v, each step begins with the look that the one before ended with.
  const shared = looks.length === 4
  let begin = from
  return [OUTER, INNER, OUTER].map((part, i) => {
    const length = part * dt
    const first = looks[shared ? i : 2 * i]!
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
