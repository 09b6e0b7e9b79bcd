import { execFileSync } from 'node:child_process'
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import ts from 'typescript'
import { build } from 'vite'
import { afterAll, beforeAll, expect, test } from 'vitest'
import type { Manifest } from '../elements/manifest.ts'
import { exact, simulate } from '../../src/physics/index.ts'
import { fixtures, standIns } from './frameworkTypes.ts'

/* What `npm pack` makes, in an empty project that has never heard of this one. */

const root = join(import.meta.dirname, '../..')
const project = mkdtempSync(join(tmpdir(), 'any-frame-rate-package-'))
afterAll(() => rmSync(project, { recursive: true, force: true }))

function run(command: string, args: string[], cwd = project): string {
  // Vitest's own NODE_ENV would build the development elements.
  const env = { ...process.env, NODE_ENV: 'production' }
  try {
    return execFileSync(command, args, { cwd, env, encoding: 'utf8', stdio: 'pipe' })
  } catch (error) {
    const { stdout, stderr } = error as { stdout: string; stderr: string }
    throw new Error(`${command} ${args.join(' ')}\n${stdout}\n${stderr}`)
  }
}

function write(name: string, text: string): void {
  writeFileSync(join(project, name), text)
}

beforeAll(() => {
  const packed = run('npm', ['pack', '--json', '--pack-destination', project], root)
  // What the build prints comes before the list.
  const [{ filename }] = JSON.parse(packed.slice(packed.search(/^\[\s*\{/m))) as [
    { filename: string },
  ]
  const manifest = { name: 'empty', private: true, type: 'module' }
  const install = ['install', '--offline', '--prefer-offline', '--no-audit', '--no-fund']
  write('package.json', JSON.stringify(manifest))
  try {
    run('npm', [...install, `./${filename}`])
  } catch {
    // npm has forgotten what it once downloaded: the same packages from where they were unpacked.
    write('package.json', JSON.stringify({ ...manifest, overrides: unpacked() }))
    run('npm', [...install, `./${filename}`])
  }
}, 240_000)

/** Every package that the elements need, by the folder that it is in. */
function unpacked(): Record<string, string> {
  const names = ['lit']
  for (const name of names) {
    const text = readFileSync(join(root, 'node_modules', name, 'package.json'), 'utf8')
    const { dependencies = {} } = JSON.parse(text) as { dependencies?: Record<string, string> }
    names.push(...Object.keys(dependencies).filter((each) => !names.includes(each)))
  }
  return Object.fromEntries(names.map((name) => [name, `file:${join(root, 'node_modules', name)}`]))
}

/** README's example, which imports the physics from the sources. */
function example(): string {
  const readme = readFileSync(join(root, 'README.md'), 'utf8')
  const [, code] = /```ts\n([^]*?createRun[^]*?)```/.exec(readme)!
  return code!.replace(/'\.\/src\/physics\/index\.ts'/, "'any-frame-rate'")
}

test('it holds the built modules and their types, and neither sources nor tests', () => {
  const home = join(project, 'node_modules/any-frame-rate')
  for (const file of ['package.json', 'README.md', 'LICENSE', 'package/physics.js'])
    expect(existsSync(join(home, file)), file).toBe(true)
  for (const folder of ['src', 'tests', 'dist', 'public'])
    expect(existsSync(join(home, folder)), folder).toBe(false)
})

test('its manifest of the elements names files and exports that are there', () => {
  const home = join(project, 'node_modules/any-frame-rate')
  const { customElements } = JSON.parse(readFileSync(join(home, 'package.json'), 'utf8')) as {
    customElements: string
  }
  const { modules } = JSON.parse(readFileSync(join(home, customElements), 'utf8')) as Manifest
  for (const { path, exports } of modules) {
    const code = readFileSync(join(home, path), 'utf8')
    for (const { kind, name } of exports)
      expect(code).toContain(kind === 'js' ? name : `customElements.define("${name}"`)
  }
})

test('README’s example runs in plain Node', () => {
  const { outputText } = ts.transpileModule(example(), {
    compilerOptions: { target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.ESNext },
  })
  write('example.js', outputText)
  const lines = run('node', ['example.js']).trim().split('\n')
  const kick = {
    scene: 'ramp',
    parameters: { angle: 15, muStatic: 0.5, muKinetic: 0.5, speed: -5 },
    duration: 1,
  } as const
  // Bit for bit what the sources give.
  const expected = [10, 30, 120].map((fps) => {
    const { s, outcome } = simulate({ ...kick, frames: { kind: 'steady', fps } })
    return `${fps} ${s.at(-1)} ${outcome.kind} ${exact(kick, 1).s}`
  })
  expect(lines.slice(0, 3)).toEqual(expected)
  expect(lines).toHaveLength(4)
})

const drift = `import { frameRateSpread } from 'any-frame-rate/spread'
const drift = frameRateSpread({
  start: () => ({ x: 0 }),
  frame: (it, dt) => void (it.x += dt * dt),
  read: ({ x }) => ({ x }),
  duration: 0.5,
})
console.log(drift.sentence)
`

test('the frame-rate spread of a game runs in plain Node', () => {
  write('drift.js', drift)
  // T Δt at 5 and at 240 fps; at 5 fps the last of three frames is half of one: 0.2² + 0.2² + 0.1².
  const apart = (0.09 - 0.5 / 240).toFixed(4)
  expect(run('node', ['drift.js'])).toMatch(
    `x ends ${apart} apart: 0.0021 (240 fps) and 0.0900 (5 fps).`,
  )
})

test('a server imports the elements, where they do nothing, and React and Vue write their tags', () => {
  write(
    'server.js',
    `import { createRequire } from 'node:module'
    import * as elements from 'any-frame-rate/elements'
    const before = Object.keys(elements).map((name) => [name, typeof elements[name]])
    const require = createRequire(${JSON.stringify(join(root, 'package.json'))})
    const { createElement } = require('react')
    const { renderToString } = require('react-dom/server')
    const { createSSRApp, h } = require('vue')
    const lab = { compact: true, fps: '10 60', experiment: '{"scene":"ramp"}' }
    const app = createSSRApp({ render: () => h('slide-lab', lab, [h('p', 'Blocks')]) })
    console.log(JSON.stringify({
      exports: Object.fromEntries(before),
      isDefined: globalThis.customElements?.get('slide-lab') !== undefined,
      react: renderToString(createElement('slide-lab', lab, createElement('p', null, 'Blocks'))),
      vue: await require('vue/server-renderer').renderToString(app),
    }))`,
  )
  // Whatever anything printed besides would stand in it.
  const printed = run('sh', ['-c', 'node server.js 2>&1'])
  const { react, vue, ...imported } = JSON.parse(printed) as Record<string, unknown>
  expect(imported).toEqual({
    exports: { SlideFigureElement: 'function', SlideLabElement: 'function', setSite: 'function' },
    isDefined: false,
  })
  for (const markup of [react, vue])
    expect(markup).toMatch(
      /^<slide-lab compact(=\S*)? fps="10 60" experiment="{&quot;scene&quot;:&quot;ramp&quot;}"><p>Blocks<\/p><\/slide-lab>$/,
    )
})

test('a server component gets the same names, which do nothing, and the reason why', () => {
  write(
    'serverComponent.js',
    `import * as elements from 'any-frame-rate/elements'
    elements.setSite(null)
    console.log(Object.keys(elements).join(), globalThis.customElements?.get('slide-lab'))`,
  )
  const printed = run('sh', ['-c', 'node --conditions react-server serverComponent.js 2>&1'])
  expect(printed).toContain("Import it in a file that begins with 'use client'.")
  expect(printed).toContain('SlideFigureElement,SlideLabElement,setSite undefined')
})

test.each(Object.entries(fixtures))(
  'the types know the tags: %s',
  (name, code) => {
    for (const [path, text] of Object.entries(standIns)) {
      mkdirSync(dirname(join(project, 'node_modules', path)), { recursive: true })
      write(join('node_modules', path), text)
    }
    const vue = join(project, 'node_modules/vue')
    if (!existsSync(vue)) symlinkSync(join(root, 'node_modules/vue'), vue, 'junction')
    write(name, code)
    const jsx =
      name === 'solid.tsx'
        ? { jsx: 'preserve', jsxImportSource: 'solid-js' }
        : { jsx: 'react-jsx', jsxImportSource: 'react' }
    const compilerOptions = {
      ...{ noEmit: true, strict: true, target: 'es2022', lib: ['es2022', 'dom', 'dom.iterable'] },
      ...{ module: 'esnext', moduleResolution: 'bundler', types: [], ...jsx },
      // The types of other packages are not part of the question. What is wrong in ours leaves errors in the fixture.
      skipLibCheck: true,
    }
    write('tsconfig.json', JSON.stringify({ compilerOptions, files: [name] }))
    expect(run(process.execPath, [join(root, 'node_modules/typescript/bin/tsc')])).toBe('')
  },
  180_000,
)

test.each(['nodenext', 'bundler'])(
  'its types hold with module resolution %s',
  (resolution) => {
    const good = `${example()}\n${drift}\nconst at: number = game.motion.s + drift.ends[0]!.end.x\nvoid at\n`
    write('example.ts', `${example()}\nconst text: string = game.motion.s\nvoid text\n`)
    write('good.ts', good)
    // The physics without a page: no DOM, and a console of its own.
    write('console.d.ts', 'declare const console: { log(...values: unknown[]): void }')
    const compilerOptions = {
      ...{ noEmit: true, strict: true, target: 'es2022', lib: ['es2022'], types: [] },
      ...{
        module: resolution === 'nodenext' ? resolution : 'esnext',
        moduleResolution: resolution,
      },
    }
    const check = (file: string) => {
      write('tsconfig.json', JSON.stringify({ compilerOptions, files: [file, 'console.d.ts'] }))
      return run(process.execPath, [join(root, 'node_modules/typescript/bin/tsc')])
    }
    expect(check('good.ts')).toBe('')
    expect(() => check('example.ts')).toThrow("Type 'number' is not assignable to type 'string'")
  },
  180_000,
)

test('the physics knows of no page and needs nothing; the elements are for a page', async () => {
  write('page.js', "import { SlideLabElement } from 'any-frame-rate/elements'\nSlideLabElement\n")
  write('physics.js', "import { simulate } from 'any-frame-rate'\nconsole.log(typeof simulate)\n")
  const code = async (input: string) => {
    const built = await build({
      ...{ root: project, configFile: false, logLevel: 'error' },
      build: { write: false, rolldownOptions: { input: join(project, input) } },
    })
    const { output } = built as { output: { type: string; code?: string }[] }
    return output.map((each) => each.code ?? '').join('\n')
  }
  expect(await code('physics.js')).not.toMatch(/\b(document|window|customElements|HTMLElement)\b/)
  const page = await code('page.js')
  expect(page).toContain('slide-figure')
  expect(page).toContain('slide-lab-plot')
})
