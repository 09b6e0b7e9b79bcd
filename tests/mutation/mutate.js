/*
 * Mutation testing of src/physics: changes the code in thousands of small ways and asks the tests about each. It works
 * on a copy, in which `as const` is taken away: Stryker leaves alone what stands before it, and here that is every
 * integrator. All of it takes many hours: `npm run mutate -- --every 7` takes each seventh function, which tells the score to
 * a few percent. Other arguments go to Stryker, e.g. `npm run mutate -- --mutate src/physics/step.ts`.
 */
import { spawnSync } from 'node:child_process'
import {
  cpSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join, resolve } from 'node:path'
import { mutable, tell } from './score.js'
import { functionsOf } from './sample.js'

const root = resolve(import.meta.dirname, '../..')
const copy = join(tmpdir(), 'any-frame-rate-mutation')
const report = join(root, 'node_modules/.cache/mutation')

rmSync(copy, { recursive: true, force: true })
mkdirSync(copy)
mkdirSync(report, { recursive: true })
for (const each of ['package.json', 'tsconfig.json', 'src', 'tests'])
  cpSync(join(root, each), join(copy, each), {
    recursive: true,
    filter: (path) => basename(path) !== 'node_modules',
  })
symlinkSync(join(root, 'node_modules'), join(copy, 'node_modules'), 'dir')

const options = process.argv.slice(2)
const asked = options.indexOf('--every')
const every = asked < 0 ? 1 : Number(options.splice(asked, 2)[1])
if (!(Number.isInteger(every) && every > 0))
  throw new Error('--every takes a whole number of functions, e.g. --every 7.')

const physics = join(copy, 'src/physics')
for (const file of readdirSync(physics, { recursive: true, encoding: 'utf8' })) {
  if (!file.endsWith('.ts')) continue
  const path = join(physics, file)
  writeFileSync(path, mutable(readFileSync(path, 'utf8')))
}

const all = functionsOf(physics)
const sample = all.filter((_, i) => i % every === every - 1)
if (every > 1) console.log(`${sample.length} of ${all.length} functions`)

/** Installed by `npm run mutate`. */
const tools = join(import.meta.dirname, 'node_modules/@stryker-mutator')

const settings = {
  testRunner: 'vitest',
  plugins: [join(tools, 'vitest-runner/dist/src/index.js'), './tests/mutation/reporter.js'],
  vitest: { configFile: 'tests/mutation/vitest.config.ts', related: false },
  coverageAnalysis: 'perTest',
  // A busy machine is no endless loop.
  timeoutMS: 3000,
  timeoutFactor: 2,
  dryRunTimeoutMinutes: 60,
  mutate:
    every === 1
      ? ['src/physics/**/*.ts']
      : sample.map(({ file, from, to }) => `src/physics/${file}:${from}-${to}`),
  // The copy is the sandbox.
  inPlace: true,
  concurrency: 2,
  reporters: ['as-they-come', 'progress-append-only'],
  incremental: true,
  // Results of other lines would count as results of the sample.
  force: every > 1,
  incrementalFile: join(report, 'incremental.json'),
}
writeFileSync(join(copy, 'stryker.config.json'), JSON.stringify(settings, null, 2))

const stryker = join(tools, 'core/bin/stryker.js')
const { status } = spawnSync(process.execPath, [stryker, 'run', ...options], {
  cwd: copy,
  stdio: 'inherit',
})
process.exitCode = status === 0 && tell(every) ? 0 : 1
