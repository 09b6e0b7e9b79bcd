import type { Attempt, PolicyStep } from '../../physics/index.ts'
import { superscript } from '../../chart/numbers.ts'
import { say } from './said.ts'
import type { Said } from './said.ts'

/** A step that a policy tried: whole, or up to the first event in it; and to see how far off that is, in two halves. */
export interface Try {
  readonly attempt: Attempt
  /** Those that it took for that, and where the first of them is among all of its frame. */
  readonly steps: readonly PolicyStep[]
  readonly first: number
}

/** The steps of a frame by the tries that they belong to; none under a policy that does not try. */
export function triesIn(steps: readonly PolicyStep[]): Try[] {
  const tries: Try[] = []
  for (let first = 0; first < steps.length;) {
    const { attempt } = steps[first]!
    let end = first + 1
    while (end < steps.length && steps[end]!.attempt === attempt) end++
    if (attempt) tries.push({ attempt, steps: steps.slice(first, end), first })
    first = end
  }
  return tries
}

/** What a step of a try is in it. */
export function partName({ steps }: Try, index: number): string {
  const whole = isCut(steps[0]!) ? 'Up to the event' : 'Whole step'
  return [whole, 'First half', 'Second half', `${whole}, to keep`][index]!
}

/** Something happens in it, which ends it. */
function isCut({ asked, dt }: PolicyStep): boolean {
  return dt < asked
}

/** What came of a try, a sentence each; `next` is the one after it in the frame. */
export function tryWords({ attempt, steps }: Try, next: Try | undefined, order: number): Said[] {
  const { error, allowed, accepted } = attempt
  const whole = steps[0]!
  const halves = steps[2] ?? steps[1]!
  const cut = isCut(whole)
  const said: Said[] = []
  if (cut)
    said.push(
      say`Something happens in the step of Δt = ${whole.asked} s: it is tried up to there, Δt = ${whole.dt} s.`,
    )
  const ends = say`Whole, it ends at s = ${whole.to.s} m with v = ${whole.to.v} m/s; in two halves, `
  const limit = say`In so long a step ${allowed} m are allowed.`
  if (error === 0) said.push([...ends, ...say`at the same, to rounding. `, ...limit])
  else {
    const apart = say`${Math.abs(halves.to.s - whole.to.s)} m and ${Math.abs(halves.to.v - whole.to.v)} m/s`
    const [power, ratio] = [`2${superscript(order)}`, 2 ** order]
    const off = cut
      ? say`times ${power}/(${power} − 1) = ${ratio}/${ratio - 1}: the whole is off by about ${error} m.`
      : say`over ${power} − 1 = ${ratio - 1}: the halves are off by about ${error} m.`
    said.push(
      [...ends, ...apart, ...say` from that.`],
      say`The two together, the speed by its way in a second, ${off} ${limit}`,
    )
  }
  const then = next ? say`The next is Δt = ${next.steps[0]!.asked} s long.` : say``
  const kept = cut
    ? say`So the whole is kept, which ends at the event exactly. ${then}`
    : say`So the halves are kept. ${then}`
  said.push(accepted ? kept : say`That is too much: all of it is taken back. ${then}`)
  return said
}
