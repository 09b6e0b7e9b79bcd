/**
 * The figures behind the page's “Hard cases”. Tests measure them by `measured`; each file ends with `published`, which
 * holds them to the file of results that the page is made from, and writes it anew by `npm run hard-cases`.
 */
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, it } from 'vitest'
import { hardCaseClaims } from '../../src/measure/hardCases/claims.ts'
import { holds, nearness } from '../../src/measure/hardCases/hardCase.ts'
import type { Bound } from '../../src/measure/hardCases/hardCase.ts'
import type { Result } from '../../src/measure/hardCases/results.ts'
import { integrators } from '../../src/physics/index.ts'
import { samples } from '../samples.ts'

const folder = join(import.meta.dirname, '../../src/measure/hardCases/results')
const renew = process.env.HARD_CASES === 'renew'

/** Of this test file, by case and claim: of all runs the one that came nearest to its bound. */
const results: Record<string, Record<string, Result>> = {}

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
  expect(holds(value, bound), `${figure} is not ${JSON.stringify(bound)}`).toBe(true)
  const ofCase = (results[hardCase] ??= {})
  const last = ofCase[claim]
  const runs = (last?.runs ?? 0) + 1
  const isWorst = !last || nearness(value, bound) > nearness(last.value, last.bound)
  ofCase[claim] = isWorst ? { run: words, runs, value, bound } : { ...last, runs }
}

/** The last test of a file: what it measured is what the page shows. */
export function published(name: string): void {
  // With fewer samples the figures are others.
  if (samples(100) < 100) return
  it('these figures are the ones on the page: npm run hard-cases measures them anew', () => {
    // Every claim is measured.
    for (const [hardCase, claims] of Object.entries(results))
      expect(Object.keys(claims).sort()).toEqual(Object.keys(hardCaseClaims[hardCase]!).sort())
    const file = join(folder, `${name}.json`)
    const text = `${JSON.stringify(results, null, 2)}\n`
    if (renew) writeFileSync(file, text)
    expect(JSON.parse(readFileSync(file, 'utf8'))).toEqual(JSON.parse(text))
  })
}
