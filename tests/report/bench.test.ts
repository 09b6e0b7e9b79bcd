import { execFileSync } from 'node:child_process'
import { join } from 'node:path'
import { expect, test } from 'vitest'

test(
  'npm run bench -- --quick runs everything and says what it found',
  { timeout: 180_000 },
  () => {
    const printed = execFileSync('npm', ['run', '--silent', 'bench', '--', '--quick'], {
      cwd: join(import.meta.dirname, '../..'),
      encoding: 'utf8',
      stdio: ['ignore', 'pipe', 'ignore'],
    })
    for (const part of [
      'Measured on',
      'One block slides down one ramp: a call for each step',
      'A call of run.frame for each step',
      'Error at the end, at 10 fps',
      'The cheapest way to an error',
      'Targets',
    ])
      expect(printed).toContain(part)
    for (const engine of ['matter-js', 'planck', 'rapier2d', 'box2d-wasm', 'odex'])
      expect(printed).toContain(engine)
    expect(printed).not.toContain('Not run')
    expect(printed).not.toMatch(/NaN|undefined|Infinity/)
  },
)
