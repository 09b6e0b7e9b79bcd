import { spawnSync } from 'node:child_process'
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { build } from 'vite'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { patched, root } from './extending.ts'

/* docs/your-game.md, followed to the letter: both tests run, fail as it says, and pass once the step is mended. */

const text = readFileSync(join(root, 'docs/your-game.md'), 'utf8')
const files = new Map(
  [...text.matchAll(/```js\n\/\/ (\S+)\n([^]*?)```/g)].map(([, name, code]) => [name!, code!]),
)
const [, told] = /```text\n(.*)\n```/.exec(text)!
const [, diff] = /```diff\n \/\/ player\.js\n([^]*?)```/.exec(text)!
const project = mkdtempSync(join(tmpdir(), 'any-frame-rate-game-'))
afterAll(() => rmSync(project, { recursive: true, force: true }))

beforeAll(async () => {
  const home = join(project, 'node_modules/any-frame-rate')
  mkdirSync(home, { recursive: true })
  await build({
    ...{ root, configFile: false, logLevel: 'silent' },
    build: {
      ...{ outDir: home, minify: false, copyPublicDir: false },
      lib: { entry: join(root, 'src/measure/gameSpread.ts'), formats: ['es'], fileName: 'spread' },
    },
  })
  const exports = { './spread': './spread.js' }
  writeFileSync(join(home, 'package.json'), JSON.stringify({ type: 'module', exports }))
  writeFileSync(join(project, 'package.json'), JSON.stringify({ type: 'module' }))
  symlinkSync(join(root, 'node_modules/vitest'), join(project, 'node_modules/vitest'), 'junction')
  for (const [name, code] of files) writeFileSync(join(project, name), code)
})

const runners = {
  Vitest: [
    join(root, 'node_modules/vitest/vitest.mjs'),
    ...['run', '--root', project, 'player.vitest.test.js'],
  ],
  'node:test': ['--test', 'player.node.test.js'],
}

function run(args: readonly string[]) {
  // A test that runs in a test would report to that one.
  const { NODE_TEST_CONTEXT, VITEST, ...env } = process.env
  void [NODE_TEST_CONTEXT, VITEST]
  const { status, stdout, stderr } = spawnSync(process.execPath, args, {
    ...{ cwd: project, encoding: 'utf8' },
    env: { ...env, NO_COLOR: '1' },
  })
  return { status, printed: stdout + stderr }
}

describe.each(Object.entries(runners))('the test with %s', (name, args) => {
  const file = args.at(-1)!

  test('has ten lines', () => {
    expect(files.get(file)!.trimEnd().split('\n')).toHaveLength(10)
  })

  test('fails on the game with the sentence that the text shows', () => {
    writeFileSync(join(project, 'player.js'), files.get('player.js')!)
    const { status, printed } = run(args)
    expect(printed).toContain(told)
    expect(status, name).toBe(1)
  })

  test('passes once the step is mended', () => {
    writeFileSync(join(project, 'player.js'), patched('player.js', files.get('player.js')!, diff!))
    const { status, printed } = run(args)
    expect(status, printed).toBe(0)
    expect(printed).toMatch(/\b1 passed|pass 1\b/)
  })
})

test('the tutorial ends its section with the test of the text', () => {
  const section = readFileSync(join(root, 'src/tutorial/text/09-what-should-i-use.md'), 'utf8')
  const [, shown] = [...section.matchAll(/```js\n([^]*?)```/g)].at(-1)!
  expect(shown).toBe(files.get('player.vitest.test.js'))
})
