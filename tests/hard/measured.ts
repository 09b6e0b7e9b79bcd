/**
 * The figures behind the page's “Hard cases”. Tests measure them by `measured`; each file ends with `published`, which
 * compares them with the results that the page is made from. `npm run hard-cases` writes those anew.
 */
import { expect, it } from 'vitest'
import { hardCaseClaims } from '../../src/measure/hardCases/claims.ts'
import { isWithin, nearness } from '../../src/measure/hardCases/hardCase.ts'
import type { Bound } from '../../src/measure/hardCases/hardCase.ts'
import { hardCaseResults } from '../../src/measure/hardCases/results.ts'
import type { Result, Results } from '../../src/measure/hardCases/results.ts'
import { integrators } from '../../src/physics/index.ts'
import { isLong, samples } from '../samples.ts'

declare module 'vitest' {
  interface TaskMeta {
    /** What a file's tests measured, for `npm run hard-cases` to write. */
    hardCases?: { name: string; results: Results }
  }
}

/** By test file, case and claim: of all runs the one that came nearest to its bound. */
const ofFiles: Record<string, Record<string, Record<string, Result>>> = {}
const ofThisFile = () => (ofFiles[expect.getState().testPath!] ??= {})

/**
 * Holds a figure to the bound of a claim, and remembers it for the page.
 *
 * @param run which run it is of, as the page says: a method by its id, a frame rate
 */
export function measured(
  hardCase: string,
  claim: string,
  run: readonly string[],
  value: number,
  bound: Bound,
): void {
  const claims = hardCaseClaims[hardCase]
  if (!claims?.[claim]) throw new Error(`Nothing is claimed of “${hardCase}” as “${claim}”.`)
  const words = run
    .map((word) => integrators.find(({ id }) => id === word)?.label ?? word)
    .join(', ')
  const figure = `${hardCase}, ${claim}: ${value} of ${words || 'the run'}`
  expect(isWithin(value, bound), `${figure} is not ${JSON.stringify(bound)}`).toBe(true)
  const ofCase = (ofThisFile()[hardCase] ??= {})
  const last = ofCase[claim]
  const runs = (last?.runs ?? 0) + 1
  const isWorst = !last || nearness(value, bound) > nearness(last.value, last.bound)
  ofCase[claim] = isWorst ? { run: words, runs, value, bound } : { ...last, runs }
}

/**
 * The last test of a file: what it measured is what the page shows. The tests leave what they measured with the task, from
 * where `npm run hard-cases` takes it.
 *
 * @param longCases the cases of which only `npm run test:long` measures all
 */
export function published(name: string, ...longCases: string[]): void {
  // With fewer samples the figures are others.
  if (samples(100) < 100) return
  it(`these figures are the ones on the page, in results/${name}.json`, ({ task }) => {
    const results = ofThisFile()
    // Every claim is measured, as far as this run goes.
    const left = isLong ? [] : longCases
    const whole = Object.entries(results).filter(([hardCase]) => !left.includes(hardCase))
    for (const [hardCase, claims] of whole)
      expect(Object.keys(claims).sort()).toEqual(Object.keys(hardCaseClaims[hardCase]!).sort())
    task.meta.hardCases = { name, results }
    for (const [hardCase, claims] of whole)
      expect(hardCaseResults[hardCase]).toEqual(JSON.parse(JSON.stringify(claims)))
  })
}
