import type { Attempt, PolicyStep } from '../../physics/index.ts'
import { superscript } from '../../chart/numbers.ts'
import { say } from './said.ts'
import type { Said } from './said.ts'

/** A step that a policy tried: whole, and to see how far off that is, in two halves. */
export interface Try {
  readonly attempt: Attempt
  /** Those that it took for that, and where the first of them is among all of its frame. */
  readonly steps: readonly PolicyStep[]
  readonly first: number
  /** Where in `steps` the one is that the halves are compared with; −1 where the run ended before there were any. */
  readonly whole: number
}

/** The steps of a frame by the tries that they belong to; none under a policy that does not try. */
export function triesIn(steps: readonly PolicyStep[]): Try[] {
  const tries: Try[] = []
  for (let first = 0; first < steps.length;) {
    const { attempt } = steps[first]!
    let end = first + 1
    while (end < steps.length && steps[end]!.attempt === attempt) end++
    if (attempt) {
      const own = steps.slice(first, end)
      const whole = own.findIndex(({ dt }, i) => own[i + 1]?.dt === 0.5 * dt)
      tries.push({ attempt, steps: own, first, whole })
    }
    first = end
  }
  return tries
}

/** What a step of a try is in it. */
export function partName({ whole }: Try, index: number): string {
  if (index > whole && whole >= 0) return index === whole + 1 ? 'First half' : 'Second half'
  return index === 0 ? 'Whole step' : 'Up to the event'
}

/** What came of a try, a sentence each; `next` is the one after it in the frame. */
export function tryWords(
  { attempt, steps, whole }: Try,
  next: Try | undefined,
  order: number,
): Said[] {
  const { error, allowed, accepted } = attempt
  const said: Said[] = []
  const tried = steps[whole]
  if (tried) {
    const halves = steps[steps.length - 1]!
    if (whole > 0)
      said.push(
        say`Something happens in the step of Δt = ${steps[0]!.dt} s: it is tried up to there, Δt = ${tried.dt} s.`,
      )
    const apart = say`${Math.abs(halves.to.s - tried.to.s)} m and ${Math.abs(halves.to.v - tried.to.v)} m/s`
    said.push(
      say`Whole, it ends at s = ${tried.to.s} m with v = ${tried.to.v} m/s; in two halves, ${apart} from that.`,
      say`The two together, the speed by its way in a second, over 2${superscript(order)} − 1 = ${2 ** order - 1}: the halves are off by about ${error} m. In so long a step ${allowed} m are allowed.`,
    )
  }
  const then = next ? say`The next is Δt = ${next.steps[0]!.dt} s long.` : say``
  said.push(
    accepted
      ? say`So the halves are kept. ${then}`
      : say`That is too much: all of it is taken back. ${then}`,
  )
  return said
}
