import { execFileSync } from 'node:child_process'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { build } from 'vite'
import { describe, expect, it } from 'vitest'
import { exact } from '../../src/physics/index.ts'

const root = join(import.meta.dirname, '../..')
const readme = readFileSync(join(root, 'README.md'), 'utf8')

describe('README', () => {
  it('its example runs headless, and prints what it promises: the same place at every frame rate, the exact one', async () => {
    const example = /```ts\n([^]*?)```/.exec(readme)![1]!
    const name = 'virtual:readme-example'
    const built = await build({
      root,
      configFile: false,
      logLevel: 'silent',
      build: {
        write: false,
        minify: false,
        rolldownOptions: { input: name, output: { format: 'es' } },
      },
      plugins: [
        {
          name: 'readme-example',
          resolveId: (id) => (id === name ? `${root}/readme-example.ts` : null),
          load: (id) => (id === `${root}/readme-example.ts` ? example : null),
        },
      ],
    })
    const { output } = (Array.isArray(built) ? built[0]! : built) as { output: { code: string }[] }
    const printed = execFileSync('node', ['--input-type=module', '--eval', output[0]!.code], {
      encoding: 'utf8',
    })
    const lines = printed.trim().split('\n')
    expect(lines).toHaveLength(4)
    const truth = exact(
      { scene: 'ramp', parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 } },
      1,
    ).s
    for (const line of lines.slice(0, 3)) {
      const [, s, outcome, exactly] = line.split(' ')
      expect(outcome).toBe('at-rest')
      expect(Number(exactly)).toBe(truth)
      expect(Math.abs(Number(s) - truth)).toBeLessThan(1e-12)
    }
  })
})
