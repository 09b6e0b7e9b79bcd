import { execFileSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { expect, onTestFinished, test } from 'vitest'
import { integrators } from '../../src/physics/index.ts'
import { timedScenes } from '../../src/report/timing/trials.ts'
import { isLong } from '../samples.ts'

function bench(...options: string[]): string {
  return execFileSync('npm', ['run', '--silent', 'bench', '--', ...options], {
    cwd: join(import.meta.dirname, '../..'),
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'pipe'],
  })
}

// It takes most of a minute, and the report's own figures are tested without it.
test.runIf(isLong)('npm run bench -- --quick runs everything and says what it found', () => {
  const printed = bench('--quick')
  for (const part of [
    'Measured on',
    'Time of a step: one block slides down one ramp',
    'Time of a step: run.frame',
    'Error at the end, at 10 fps',
    'The cheapest way to an error',
    'Targets',
  ])
    expect(printed).toContain(part)
  for (const engine of ['matter-js', 'planck', 'rapier2d', 'box2d-wasm', 'odex'])
    expect(printed).toContain(engine)
  expect(printed).not.toContain('Not run')
  expect(printed).not.toMatch(/NaN|undefined|Infinity/)
})

// It is the measuring of the test above, twice.
test.runIf(isLong)(
  'npm run bench -- --against compares every scene and method with another checkout',
  () => {
    const printed = bench('--against', '.', '--quick')
    expect(printed.match(/^run\.frame, one call a step/gm)).toHaveLength(3)
    expect(printed.match(/^simulate, ten thousand frames/gm)).toHaveLength(1)
    // Its scenes by all methods, three rows for themselves and the two worst; each with a ratio.
    const rows = timedScenes.length * integrators.length + 5
    expect(printed.match(/^\S.*, .*\s[nµ]s\s.*\s\d\.\d{3}\s/gm)).toHaveLength(rows)
    expect(printed).not.toMatch(/NaN|undefined|Infinity/)
  },
)

test('npm run bench -- --against refuses what is no checkout', () => {
  expect(() => bench('--against', 'tests')).toThrow()
})

test('npm run bench -- --against runs the other checkout’s physics, and not its own twice', () => {
  const other = mkdtempSync(join(tmpdir(), 'any-frame-rate-other-'))
  onTestFinished(() => {
    rmSync(other, { recursive: true })
  })
  mkdirSync(join(other, 'src/physics'), { recursive: true })
  writeFileSync(
    join(other, 'src/physics/index.ts'),
    `export const [createRun, simulate] = []
    export const [integrators, scenes, stoppings, timesteps] = [[], [], [], []]
    throw new Error('Other physics.')`,
  )
  expect(() => bench('--against', other, '--quick')).toThrow(/Other physics\./)
})
