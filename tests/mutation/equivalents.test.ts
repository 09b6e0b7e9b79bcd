import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, it } from 'vitest'
import equivalents from './equivalents.json'
import result from './result.json'

const physics = join(import.meta.dirname, '../../src/physics')

describe('the list of mutants that change nothing', () => {
  it.each(equivalents)('$file: $line', ({ file, line, why }) => {
    const lines = readFileSync(join(physics, file), 'utf8').replaceAll(/ as const\b/g, '')
    expect(lines.split('\n').some((each) => each.includes(line))).toBe(true)
    expect(why).toMatch(/^[A-Z].*\.$/)
  })

  it('is short, and nearly complete: of a hundred mutants six are not found, and five of them are in it', () => {
    expect(equivalents.length).toBeLessThanOrEqual(80)
    expect(result.survived).toBeLessThanOrEqual(0.01 * result.mutants)
    expect(result.percent).toBeGreaterThanOrEqual(94)
  })
})
