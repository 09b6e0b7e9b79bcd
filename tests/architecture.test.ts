import { readdirSync, readFileSync } from 'node:fs'
import { join, posix, resolve } from 'node:path'
import ts from 'typescript'
import { expect, test } from 'vitest'

// What each folder of src may import besides itself: other folders, npm packages, `node:` for Node.
type Rule = { runtime: string[]; types: string[] }

const rules: Record<string, Rule> = {
  physics: { runtime: [], types: [] },
  measure: { runtime: ['physics'], types: [] },
  view: { runtime: [], types: ['physics'] },
  figure: { runtime: ['physics', 'measure', 'view', 'lit'], types: ['report'] },
  elements: { runtime: ['physics', 'figure', 'styles', 'lit'], types: [] },
  tutorial: { runtime: ['figure'], types: [] },
  // Rooms of the tutorial that are for the build alone: nothing of them is in the page.
  'tutorial/build': {
    runtime: [
      ...['node:', 'vite', 'markdown-it', 'temml', 'shiki'],
      ...['physics', 'measure', 'view', 'figure', 'tutorial/facts'],
    ],
    types: [],
  },
  'tutorial/facts': { runtime: ['physics', 'measure', 'view'], types: [] },
  // Code to be copied: it stands on its own.
  'tutorial/take-home': { runtime: [], types: [] },
  report: {
    runtime: [
      ...['physics', 'measure', 'node:', 'vite', 'prettier'],
      // What is compared with, and what draws.
      ...['matter-js', 'planck', '@dimforge/rapier2d-compat', 'box2d-wasm', 'odex'],
      ...['@observablehq/plot', 'linkedom'],
    ],
    types: [],
  },
}

type Import = { specifier: string; typeOnly: boolean }

test('the imports under src run the right way', () => {
  const src = resolve(import.meta.dirname, '../src')
  const files = readdirSync(src, { recursive: true, encoding: 'utf8' })
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => path.endsWith('.ts'))
  expect(files.length).toBeGreaterThan(0)
  expect(files.flatMap((path) => violations(path, readFileSync(join(src, path), 'utf8')))).toEqual(
    [],
  )
})

test.each([
  ['physics/a.ts', "import { x } from './scenes/ramp.ts'", true],
  ['physics/scenes/a.ts', "import { x } from '../motion.ts'", true],
  ['physics/scenes/a.ts', "import { x } from '../../measure/error.ts'", false],
  ['physics/a.ts', "import type { X } from '../measure/error.ts'", false],
  ['physics/a.ts', "import { html } from 'lit'", false],
  ['physics/a.ts', "import type { Stats } from 'node:fs'", false],
  ['physics/a.ts', "export * from '../view/track.ts'", false],
  ['physics/a.ts', "const late = () => import('../figure/lab.ts')", false],
  ['physics/a.ts', "type X = import('../figure/lab.ts').X", false],
  ['measure/a.ts', "import { simulate } from '../physics/index.ts'", true],
  ['measure/a.ts', "import '../view/track.ts'", false],
  ['measure/a.ts', "new Worker(new URL('../figure/w.ts', import.meta.url))", false],
  ['measure/a.ts', "new Worker(new URL('./w.ts', import.meta.url))", true],
  ['view/a.ts', "import type { Trajectory } from '../physics/index.ts'", true],
  ['view/a.ts', "import { simulate } from '../physics/index.ts'", false],
  ['view/a.ts', "import { type Trajectory } from '../physics/index.ts'", false],
  ['figure/a.ts', "import { html } from 'lit'", true],
  ['figure/a.ts', "import { repeat } from 'lit/directives/repeat.js'", true],
  ['figure/a.ts', "import { x } from 'literal'", false],
  ['figure/a.ts', "import { x } from '../tutorial/text.ts'", false],
  ['tutorial/a.ts', "import '../figure/define.ts'", true],
  ['tutorial/a.ts', "import './page/a.ts'", true],
  ['tutorial/a.ts', "import { simulate } from '../physics/index.ts'", false],
  ['tutorial/a.ts', "import './build/a.ts'", false],
  ['tutorial/page/a.ts', "import { simulate } from '../../physics/index.ts'", false],
  ['tutorial/page/a.ts', "import { facts } from '../facts/index.ts'", false],
  ['tutorial/build/a.ts', "import { simulate } from '../../physics/index.ts'", true],
  ['tutorial/build/still/a.ts', "import { html } from '../html.ts'", true],
  ['tutorial/build/a.ts', "import { facts } from '../facts/index.ts'", true],
  ['tutorial/build/a.ts', "import { dial } from '../page/dial.ts'", false],
  ['tutorial/build/a.ts', "import { html } from 'lit'", false],
  ['tutorial/facts/a.ts', "import { readFileSync } from 'node:fs'", false],
  ['tutorial/take-home/a.ts', "import { simulate } from '../../physics/index.ts'", false],
  ['figure/a.ts', "import '../tutorial/build/a.ts'", false],
  ['report/a.ts', "import { writeFileSync } from 'node:fs'", true],
  ['report/a.ts', "import { x } from '../view/track.ts'", false],
  ['elsewhere/a.ts', 'export const x = 1', false],
  ['main.ts', "import './figure/define.ts'", true],
])('the test above, given %s with %s', (path, text, allowed) => {
  expect(violations(path, text).length === 0).toBe(allowed)
})

/** What is wrong with a file's imports. Files that lie in src itself tie the folders together: they may import all. */
function violations(path: string, text: string): string[] {
  if (!path.includes('/')) return []
  const folder = roomOf(path)
  const rule = rules[folder]
  if (!rule) return [`src/${folder} has no rule: give it one in this test`]
  return imports(path, text)
    .filter(({ specifier, typeOnly }) => {
      const target = targetOf(path, specifier)
      return !(
        target === folder ||
        rule.runtime.includes(target) ||
        (typeOnly && rule.types.includes(target))
      )
    })
    .map(({ specifier }) => `src/${path} may not import ${specifier}`)
}

/** The folder of src that a relative import leads to, or the name of a package. */
function targetOf(path: string, specifier: string): string {
  if (specifier.startsWith('node:')) return 'node:'
  if (!specifier.startsWith('.')) {
    return specifier
      .split('/')
      .slice(0, specifier.startsWith('@') ? 2 : 1)
      .join('/')
  }
  return roomOf(posix.join(posix.dirname(path), specifier))
}

/** The folder of src that a file is in: the inner one where that has a rule of its own. */
function roomOf(path: string): string {
  const [outer, inner] = path.split('/')
  return inner !== undefined && `${outer}/${inner}` in rules ? `${outer}/${inner}` : outer!
}

/** Every module that a file names: imported, exported from, imported late, named as a type or as a worker. */
function imports(path: string, text: string): Import[] {
  const found: Import[] = []
  const add = (node: ts.Node | undefined, typeOnly: boolean) => {
    if (node && ts.isStringLiteralLike(node)) found.push({ specifier: node.text, typeOnly })
  }
  const visit = (node: ts.Node): void => {
    if (ts.isImportDeclaration(node)) {
      add(node.moduleSpecifier, node.importClause?.phaseModifier === ts.SyntaxKind.TypeKeyword)
    } else if (ts.isExportDeclaration(node)) {
      add(node.moduleSpecifier, node.isTypeOnly)
    } else if (ts.isImportTypeNode(node) && ts.isLiteralTypeNode(node.argument)) {
      add(node.argument.literal, true)
    } else if (ts.isCallExpression(node) && node.expression.kind === ts.SyntaxKind.ImportKeyword) {
      add(node.arguments[0], false)
    } else if (ts.isNewExpression(node) && node.expression.getText() === 'URL') {
      if (node.arguments?.[1]?.getText() === 'import.meta.url') add(node.arguments[0], false)
    }
    ts.forEachChild(node, visit)
  }
  visit(ts.createSourceFile(path, text, ts.ScriptTarget.Latest, true))
  return found
}
