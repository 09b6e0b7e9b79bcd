import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, it } from 'vitest'
import { hardCases } from '../../src/measure/index.ts'
import { isWithin } from '../../src/measure/hardCases/hardCase.ts'
import { hardCaseClaims } from '../../src/measure/hardCases/claims.ts'
import { hardCaseResults } from '../../src/measure/hardCases/results.ts'
import { ExperimentError, parseExperiment } from '../../src/physics/index.ts'

describe('the hard cases', () => {
  it('are of twenty-eight groups, in their order, each with a name of its own', () => {
    const groups = hardCases.map(({ group }) => group)
    expect(groups).toEqual([...groups].sort((a, b) => a - b))
    expect(new Set(groups)).toEqual(new Set(Array.from({ length: 28 }, (_, i) => i + 1)))
    for (const key of ['id', 'label'] as const)
      expect(new Set(hardCases.map((each) => each[key])).size).toBe(hardCases.length)
  })

  it.each(hardCases)('$id says what to watch, in a sentence, and what holds', (each) => {
    expect(each.id).toMatch(/^[a-z\d-]+$/)
    expect(each.watch).toMatch(/^\S[^]*[^.]\.$/)
    expect(each.label.length).toBeLessThanOrEqual(50)
    const claims = Object.values(hardCaseClaims[each.id]!)
    expect(claims.length).toBeGreaterThan(0)
    for (const { what, why } of claims) {
      expect(what).toMatch(/^[A-Z][^]*[^.]$/)
      expect(why).toMatch(/^[^A-Z][^]*[^.]$/)
    }
  })

  it.each(hardCases)('$id can be run, or is refused if it says so', ({ experiments, refused }) => {
    expect(experiments.length).toBeGreaterThanOrEqual(1)
    // As many as the lab shows side by side.
    expect(experiments.length).toBeLessThanOrEqual(8)
    for (const experiment of experiments) {
      const parse = () => parseExperiment(JSON.parse(JSON.stringify(experiment)))
      if (refused) expect(parse).toThrow(ExperimentError)
      else expect(parse).not.toThrow()
    }
  })

  it('are all that something is claimed of', () => {
    expect(Object.keys(hardCaseClaims).sort()).toEqual(hardCases.map(({ id }) => id).sort())
  })

  it('have a result for every claim, within its bound', () => {
    for (const { id } of hardCases) {
      const results = hardCaseResults[id]!
      expect(Object.keys(results).sort()).toEqual(Object.keys(hardCaseClaims[id]!).sort())
      for (const { value, bound } of Object.values(results))
        expect(isWithin(value, bound)).toBe(true)
    }
  })

  it('are each tested by name', () => {
    const folder = import.meta.dirname
    const tests = readdirSync(folder)
      .filter((name) => name.endsWith('.test.ts'))
      .map((name) => readFileSync(join(folder, name), 'utf8'))
      .join('')
    for (const { id } of hardCases) expect(tests, id).toContain(`'${id}'`)
  })
})
