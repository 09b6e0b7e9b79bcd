import { describe, expect, it } from 'vitest'
import { readAddress } from '../../src/lab/state/address.ts'
import { hardCaseClaims } from '../../src/measure/hardCases/claims.ts'
import type { Claim } from '../../src/measure/hardCases/hardCase.ts'
import { hardCases } from '../../src/measure/index.ts'
import { hardCaseResults } from '../../src/measure/hardCases/results.ts'
import { ExperimentError, parseExperiment } from '../../src/physics/index.ts'
import { Book } from '../../src/tutorial/build/book.ts'
import {
  boundText,
  claimRow,
  valueText,
  hardCasesHtml,
} from '../../src/tutorial/build/hardCases.ts'

const book = new Book({
  ...{ texts: [], facts: {}, figures: [], takeHome: [], pageIds: [] },
  read: () => undefined,
})
const built = hardCasesHtml({ book, highlight: () => '', file: 'hard-cases.md', firstLine: 0 }, 0)

/** What the table says of each case. */
const bodies = new Map(
  [...built.matchAll(/<tbody id="hard-case-([^"]+)"[^]*?<\/tbody>/g)].map(
    (match) => [match[1]!, match[0]] as const,
  ),
)

describe('the table of hard cases', () => {
  it('has each case once, of all twenty-eight groups', () => {
    expect([...bodies.keys()].sort()).toEqual(hardCases.map(({ id }) => id).sort())
    const groups = [...built.matchAll(/data-group="(\d+)"/g)].map((match) => Number(match[1]))
    expect(new Set(groups).size).toBe(28)
    expect(book.problems).toEqual([])
  })

  it.each(hardCases)('$id: a name, what to watch, and a row for every claim', (each) => {
    const body = bodies.get(each.id)!
    expect(body).toContain(`href="#hard-case-${each.id}">${each.label}</a>`)
    expect(body).toContain(each.watch)
    const claims = Object.entries(hardCaseClaims[each.id]!)
    expect(body.match(/<th scope="row">/g)).toHaveLength(claims.length)
    for (const [name, { what, why, failure }] of claims) {
      const words = body.replace(/<\/?span[^>]*>/g, '')
      for (const each of [what, why]) expect(words).toContain(each)
      if (failure) expect(body).toContain(`${failure}: as documented`)
      expect(body).toContain(`title="${hardCaseResults[each.id]![name]!.value}`)
    }
  })

  it.each(hardCases)('$id: links that open its experiments, or that the lab refuses', (each) => {
    const addresses = [...bodies.get(each.id)!.matchAll(/href="#([^"]+)" data-lab=""/g)].map(
      (match) => match[1]!.replaceAll('&amp;', '&'),
    )
    if (each.refused) {
      expect(addresses).toHaveLength(1)
      expect(() => readAddress(addresses[0]!)).toThrow(ExperimentError)
      return
    }
    const runs = addresses.map(readAddress).flatMap(({ scene, parameters, timeScale, runners }) =>
      runners.map(({ integrator, stopping, timestep, frames }) => ({
        ...{ scene, parameters, timeScale, integrator, stopping, timestep, frames },
      })),
    )
    const experiments = each.experiments.map(parseExperiment)
    expect(runs).toHaveLength(experiments.length)
    // The lab may run them for less long.
    for (const experiment of experiments) {
      const run: Partial<typeof experiment> = { ...experiment }
      delete run.duration
      expect(runs).toContainEqual(run)
    }
  })

  it('gives every link a name of its own', () => {
    const names = [...built.matchAll(/data-lab="" aria-label="([^"]+)"/g)].map((match) => match[1])
    expect(new Set(names).size).toBe(names.length)
    expect(names.length).toBeGreaterThanOrEqual(hardCases.length)
  })
})

describe('figures', () => {
  const claim = (others: Partial<Claim> = {}): Claim => ({
    ...{ what: 'Verlet: off at the end', why: 'theory', unit: 'm', ...others },
  })

  it.each([
    [claim(), { atMost: 0.25 }, '≤\u202f0.25\u202fm'],
    [claim(), { atMost: 0 }, 'exactly 0'],
    [claim({ rounding: true }), { atMost: 1e-10 }, '0 (to rounding)'],
    [claim({ unit: 'm/s' }), { above: 0 }, 'more than 0'],
    [claim(), { atLeast: 5 }, 'at least 5\u202fm'],
    [claim({ unit: 's' }), { atLeast: 1, atMost: 5 }, '1\u202fs to 5\u202fs'],
    [claim({ unit: 'things' }), { atLeast: 20000, atMost: 20000 }, 'exactly 20\u202f000'],
    [claim({ unit: 'of the energy' }), { atMost: 0.01 }, '≤\u202f1\u202f%'],
    // What differs by roundings only is one figure.
    [claim(), { atLeast: 0.00135, atMost: 0.00135 + 1e-17 }, '1.35\u202fmm'],
  ])('bound %#', (of, bound, text) => {
    expect(boundText(of, bound)).toBe(text)
  })

  it('a value of rounding is 0, and one that is not keeps its digits', () => {
    expect(valueText(claim({ rounding: true }), 3e-15)).toBe('0 (to rounding)')
    expect(valueText(claim({ rounding: true }), 0)).toBe('0')
    expect(valueText(claim(), 2.8e-9)).toBe('2.8\u202fnm')
    expect(valueText(claim({ unit: 'J' }), 2)).toBe('2\u202fJ')
  })

  it('a row says which run its figure is of, unless all are alike or it is named', () => {
    const row = (run: string, runs: number, value: number, atMost: number) =>
      claimRow(claim(), { run, runs, value, bound: { atMost } })
    expect(row('Midpoint, 5 fps', 6, 0.1, 0.2)).toContain('Midpoint, 5 fps, of 6 runs')
    expect(row('Midpoint, 5 fps', 6, 0, 0)).toContain('>all 6 runs<')
    expect(row('Midpoint', 1, 0.1, 0.2)).toContain('>Midpoint<')
    expect(row('Verlet', 1, 0.1, 0.2)).not.toContain('class="run"')
    expect(row('Midpoint', 1, 0.1, 0.2)).toContain('title="at most 0.2 m"')
    expect(row('Midpoint', 1, 0.1, 0.2)).toContain('title="0.1 m"')
  })
})
