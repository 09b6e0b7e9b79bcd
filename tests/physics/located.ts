import { exactMotion, simulate } from '../../src/physics/index.ts'
import type { Experiment, IntegratorId, State } from '../../src/physics/index.ts'
import { last } from './truth.ts'

/** Where an experiment ends in truth, and where the block comes to rest at last; NaN where it never does. */
export interface End extends State {
  rest: number
}

/** Long enough for any block that friction stops at all, in the cases of generated.ts [s]. */
const FOREVER = 1e7

/** The truth at the end of each experiment. */
export function endsOf(experiments: readonly Experiment[]): End[] {
  return experiments.map((each) => {
    const truth = exactMotion(each)
    const end = truth(each.duration!, { s: 0, v: 0 })
    const at = truth(FOREVER, { s: 0, v: 0 })
    return { ...end, rest: at.v === 0 ? at.s : NaN }
  })
}

/** How far the runs of one method end from the truth; cases by their index. */
export interface Located {
  /** More than 0.5 m off, or diverged. */
  overHalf: number[]
  /** More than 100 m off, or NaN. */
  overHundred: number[]
  /** The largest error [m], and its case. */
  largest: number
  largestAt: number
  /**
   * At rest where the block does not come to rest within 0.5 m, now or later: a method's error may stop it a little
   * early, but not somewhere else.
   */
  falseRests: number[]
  /** s, v or heat is no number somewhere. */
  noNumber: number[]
  evaluations: number
}

/** Runs all of them with one method. */
export function located(
  experiments: readonly Experiment[],
  ends: readonly End[],
  integrator: IntegratorId,
): Located {
  const result: Located = {
    ...{ overHalf: [], overHundred: [], largest: 0, largestAt: -1 },
    ...{ falseRests: [], noNumber: [], evaluations: 0 },
  }
  experiments.forEach((experiment, i) => {
    const run = simulate({ ...experiment, integrator })
    const { kind } = run.outcome
    const s = last(run.s)
    const error = Math.abs(s - ends[i]!.s)
    if (!(error <= 0.5) || kind === 'diverged') result.overHalf.push(i)
    if (!(error <= 100)) result.overHundred.push(i)
    if (error > result.largest) {
      result.largest = error
      result.largestAt = i
    }
    if (kind === 'at-rest' && !(Math.abs(s - ends[i]!.rest) <= 0.5)) result.falseRests.push(i)
    if ([run.s, run.v, run.heat].some((column) => column.some(Number.isNaN)))
      result.noNumber.push(i)
    result.evaluations += run.evaluations
  })
  return result
}

/** One line of what was found. */
export function summary(name: string, count: number, found: Located): string {
  return [
    `${name}: ${((100 * found.overHalf.length) / count).toFixed(2)} % over 0.5 m or diverged`,
    `${found.overHundred.length} over 100 m`,
    `largest ${found.largest.toPrecision(3)} m in case ${found.largestAt}`,
    `${found.falseRests.length} at rest that are not`,
    `${found.noNumber.length} no number`,
    `${(found.evaluations / count).toFixed(0)} evaluations a run`,
  ].join(', ')
}
