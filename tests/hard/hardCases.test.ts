import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, it } from 'vitest'
import { hardCaseClaims, hardCases } from '../../src/measure/index.ts'
import { ExperimentError, parseExperiment } from '../../src/physics/index.ts'

describe('the hard cases', () => {
  it('are of seventeen groups, in their order, each with a name of its own', () => {
    const groups = hardCases.map(({ group }) => group)
    expect(groups).toEqual([...groups].sort((a, b) => a - b))
    expect(new Set(groups)).toEqual(new Set(Array.from({ length: 17 }, (_, i) => i + 1)))
    for (const key of ['id', 'label'] as const)
      expect(new Set(hardCases.map((each) => each[key])).size).toBe(hardCases.length)
  })

  it.each(hardCases)('$id says what to watch and what holds, a sentence each', (each) => {
    expect(each.id).toMatch(/^[a-z\d-]+$/)
    for (const sentence of [each.watch, hardCaseClaims[each.id]])
      expect(sentence).toMatch(/^\S[^]*[^.]\.$/)
    expect(each.label.length).toBeLessThanOrEqual(50)
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

  it('are each tested by name', () => {
    const folder = import.meta.dirname
    const tests = readdirSync(folder)
      .filter((name) => name.endsWith('.test.ts'))
      .map((name) => readFileSync(join(folder, name), 'utf8'))
      .join('')
    for (const { id } of hardCases) expect(tests, id).toContain(`'${id}'`)
  })
})
