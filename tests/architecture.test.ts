import { readdirSync, readFileSync } from 'node:fs'
import { join, posix, resolve } from 'node:path'
import ts from 'typescript'
import { expect, test } from 'vitest'

// What each folder of src may import besides itself: other folders, npm packages, `node:` for Node.
type Rule = { runtime: string[]; types: string[] }

/** What the lab is made of, below the panels that it can open. */
const lab = ['lab', 'lab/state', 'lab/presets', 'lab/playback', 'engines']
/** What every panel is made of. Panels are not among it: they do not know each other. */
const panel = ['physics', 'measure', 'chart', 'view', 'ui', ...lab, 'lit']
const panels = [
  ...['runners', 'parameters', 'forces', 'plots', 'measures'],
  ...['inspector', 'record', 'share', 'strip'],
].map((name) => `panels/${name}`)

const rules: Record<string, Rule> = {
  physics: { runtime: [], types: [] },
  measure: { runtime: ['physics'], types: [] },
  chart: { runtime: [], types: [] },
  logs: { runtime: [], types: [] },
  engines: { runtime: [], types: ['physics'] },
  view: { runtime: ['chart'], types: ['physics'] },
  ui: { runtime: ['chart', 'view', 'lit'], types: ['physics'] },
  // Plain values: no lit, and nothing that draws.
  'lab/state': { runtime: ['physics', 'measure', 'chart', 'engines'], types: [] },
  'lab/presets': { runtime: ['physics', 'measure', 'chart', 'engines', 'lab/state'], types: [] },
  'lab/playback': { runtime: ['view', 'ui', 'lit'], types: ['physics'] },
  lab: { runtime: ['physics', 'measure', 'chart', 'view', 'ui', ...lab, 'lit'], types: [] },
  ...Object.fromEntries(panels.map((room) => [room, { runtime: panel, types: [] }])),
  'panels/measures': { runtime: panel, types: ['report'] },
  'panels/record': { runtime: [...panel, 'logs'], types: [] },
  // Files in panels itself put the panels into a lab.
  panels: { runtime: [...panel, ...panels], types: [] },
  figures: {
    runtime: [
      ...[
        'physics',
        'measure',
        'engines',
        'chart',
        'view',
        'ui',
        'lab/state',
        'lab/playback',
        'lit',
      ],
      // The recorder of frames, and as one of the figures a diagram of the lab.
      ...['panels/record', 'panels/measures'],
    ],
    types: [],
  },
  elements: {
    runtime: ['physics', 'chart', 'ui', ...lab, 'panels', 'figures', 'styles', 'lit'],
    types: [],
  },
  // What runs in the page: numbers are written and read as in figures.
  tutorial: { runtime: ['chart'], types: [] },
  // Rooms of the tutorial that are for the build alone: nothing of them is in the page.
  'tutorial/build': {
    runtime: [
      ...['node:', 'vite', 'markdown-it', 'temml', 'shiki'],
      ...['physics', 'measure', 'chart', 'view', ...lab, 'figures'],
      ...['tutorial/facts', 'tutorial/still'],
    ],
    types: [],
  },
  'tutorial/still': { runtime: ['chart', 'view', ...lab, 'figures'], types: [] },
  'tutorial/facts': { runtime: ['physics', 'measure', 'chart', 'view'], types: [] },
  // Code to be copied: it stands on its own.
  'tutorial/take-home': { runtime: [], types: [] },
  report: {
    runtime: [
      ...['physics', 'measure', 'chart', 'node:', 'vite', 'prettier'],
      // What is compared with, and what draws.
      ...['matter-js', 'planck', '@dimforge/rapier2d-compat', 'box2d-wasm', 'odex'],
      ...['@observablehq/plot', 'linkedom'],
    ],
    types: [],
  },
}

type Import = { specifier: string; typeOnly: boolean }

const src = resolve(import.meta.dirname, '../src')

/** What every module under src imports, by its path from there. */
const modules = new Map(
  readdirSync(src, { recursive: true, encoding: 'utf8' })
    .map((path) => path.replaceAll('\\', '/'))
    .filter((path) => path.endsWith('.ts'))
    .map((path) => [path, imports(path, readFileSync(join(src, path), 'utf8'))]),
)

test('the imports under src run the right way', () => {
  expect(modules.size).toBeGreaterThan(0)
  expect([...modules].flatMap(([path, all]) => violations(path, all))).toEqual([])
})

test('no files import each other in a circle, types included', () => {
  expect(circles(importsOf((path) => path))).toEqual([])
})

test('no folders import each other in a circle, types included', () => {
  // A folder of physics is a list: its entries know the types beside the folder, where the parser knows the lists.
  const folderOf = (path: string) => (path.startsWith('physics/') ? 'physics' : posix.dirname(path))
  expect(circles(importsOf(folderOf))).toEqual([])
  expect(circles(importsOf((path) => path.split('/')[0]!))).toEqual([])
})

test('a circle is found, and what only leads to one is none', () => {
  const graph = { a: ['b'], b: ['c', 'd'], c: ['a'], d: ['d'], e: ['a'] }
  const sets = Object.entries(graph).map(([name, all]) => [name, new Set(all)] as const)
  expect(circles(new Map(sets))).toEqual([['a', 'b', 'c']])
})

/** What imports what, each file put into a group; what groups import of themselves left out. */
function importsOf(groupOf: (path: string) => string): Map<string, Set<string>> {
  const graph = new Map<string, Set<string>>()
  for (const [path, all] of modules) {
    const group = groupOf(path)
    const found = graph.get(group) ?? new Set()
    graph.set(group, found)
    for (const { specifier } of all) {
      const target = posix.join(posix.dirname(path), specifier)
      if (modules.has(target) && groupOf(target) !== group) found.add(groupOf(target))
    }
  }
  return graph
}

/** Every group of names that lead to each other, sorted (Tarjan's strongly connected components). */
function circles(graph: ReadonlyMap<string, ReadonlySet<string>>): string[][] {
  const found: string[][] = []
  const stack: string[] = []
  const order = new Map<string, number>()
  const visit = (name: string): number => {
    const own = order.size
    order.set(name, own)
    stack.push(name)
    let lowest = own
    for (const next of graph.get(name) ?? []) {
      if (!order.has(next)) lowest = Math.min(lowest, visit(next))
      else if (stack.includes(next)) lowest = Math.min(lowest, order.get(next)!)
    }
    if (lowest === own) {
      const circle = stack.splice(stack.indexOf(name))
      if (circle.length > 1) found.push(circle.sort())
    }
    return lowest
  }
  for (const name of graph.keys()) if (!order.has(name)) visit(name)
  return found
}

test.each([
  ['physics/a.ts', "import { x } from './scenes/ramp.ts'", true],
  ['physics/scenes/a.ts', "import { x } from '../motion.ts'", true],
  ['physics/scenes/a.ts', "import { x } from '../../measure/error.ts'", false],
  ['physics/a.ts', "import type { X } from '../measure/error.ts'", false],
  ['physics/a.ts', "import { html } from 'lit'", false],
  ['physics/a.ts', "import type { Stats } from 'node:fs'", false],
  ['physics/a.ts', "export * from '../view/track.ts'", false],
  ['physics/a.ts', "const late = () => import('../lab/lab.ts')", false],
  ['physics/a.ts', "type X = import('../lab/lab.ts').X", false],
  ['measure/a.ts', "import { simulate } from '../physics/index.ts'", true],
  ['measure/a.ts', "import '../view/track.ts'", false],
  ['measure/a.ts', "new Worker(new URL('../panels/w.ts', import.meta.url))", false],
  ['measure/a.ts', "new Worker(new URL('./w.ts', import.meta.url))", true],
  ['view/a.ts', "import type { Trajectory } from '../physics/index.ts'", true],
  ['view/a.ts', "import { simulate } from '../physics/index.ts'", false],
  ['view/a.ts', "import { type Trajectory } from '../physics/index.ts'", false],
  ['view/a.ts', "import { fixed } from '../chart/numbers.ts'", true],
  ['chart/a.ts', "import type { Palette } from '../view/palette.ts'", false],
  ['ui/a.ts', "import { html } from 'lit'", true],
  ['ui/a.ts', "import { repeat } from 'lit/directives/repeat.js'", true],
  ['ui/a.ts', "import { x } from 'literal'", false],
  ['ui/a.ts', "import type { LabState } from '../lab/state/state.ts'", false],
  ['lab/state/a.ts', "import { spreadOf } from '../../measure/index.ts'", true],
  ['lab/state/a.ts', "import { html } from 'lit'", false],
  ['lab/state/a.ts', "import type { Picture } from '../../view/picture.ts'", false],
  ['lab/state/a.ts', "import type { Lab } from '../lab.ts'", false],
  ['lab/playback/a.ts', "import { onVisible } from '../../ui/sight.ts'", true],
  ['lab/playback/a.ts', "import type { LabState } from '../state/state.ts'", false],
  ['lab/a.ts', "import { Playback } from './playback/playback.ts'", true],
  ['lab/a.ts', "const late = () => import('../panels/instruments.ts')", false],
  ['panels/plots/a.ts', "import type { LabView } from '../../lab/labView.ts'", true],
  ['panels/plots/a.ts', "import { save } from '../share/shareMenu.ts'", false],
  ['panels/plots/a.ts', "import type { Measured } from '../measures/loading.ts'", false],
  ['panels/record/a.ts', "import { readLog } from '../../logs/index.ts'", true],
  ['panels/plots/a.ts', "import { readLog } from '../../logs/index.ts'", false],
  ['logs/a.ts', "import { fixed } from '../chart/numbers.ts'", false],
  ['panels/plots/a.ts', "import { instruments } from '../instruments.ts'", false],
  ['panels/measures/a.ts', "import type { Report } from '../../report/schema.ts'", true],
  ['panels/runners/a.ts', "import type { Report } from '../../report/schema.ts'", false],
  ['panels/elsewhere/a.ts', "import '../plots/labPlots.ts'", false],
  ['panels/a.ts', "import './plots/labPlots.ts'", true],
  ['figures/a.ts', "import { record } from '../panels/record/recording.ts'", true],
  ['figures/a.ts', "import '../panels/share/shareMenu.ts'", false],
  ['figures/a.ts', "import { x } from '../tutorial/text.ts'", false],
  ['tutorial/a.ts', "import '../figures/element/slideFigure.ts'", false],
  ['tutorial/a.ts', "import './page/a.ts'", true],
  ['tutorial/a.ts', "import { simulate } from '../physics/index.ts'", false],
  ['tutorial/a.ts', "import './build/a.ts'", false],
  ['tutorial/page/a.ts', "import { simulate } from '../../physics/index.ts'", false],
  ['tutorial/page/a.ts', "import { facts } from '../facts/index.ts'", false],
  ['tutorial/build/a.ts', "import { simulate } from '../../physics/index.ts'", true],
  ['tutorial/build/a.ts', "import { escaped } from '../still/html.ts'", true],
  ['tutorial/still/a.ts', "import { Book } from '../build/book.ts'", false],
  ['tutorial/build/a.ts', "import { facts } from '../facts/index.ts'", true],
  ['tutorial/build/a.ts', "import { dial } from '../page/dial.ts'", false],
  ['tutorial/build/a.ts', "import { html } from 'lit'", false],
  ['tutorial/facts/a.ts', "import { readFileSync } from 'node:fs'", false],
  ['tutorial/take-home/a.ts', "import { simulate } from '../../physics/index.ts'", false],
  ['figures/a.ts', "import '../tutorial/build/a.ts'", false],
  ['report/a.ts', "import { writeFileSync } from 'node:fs'", true],
  ['report/a.ts', "import { x } from '../view/track.ts'", false],
  ['elsewhere/a.ts', 'export const x = 1', false],
  ['main.ts', "import './panels/slideLab.ts'", true],
])('the test above, given %s with %s', (path, text, allowed) => {
  expect(violations(path, imports(path, text)).length === 0).toBe(allowed)
})

/** What is wrong with a file's imports. Files that lie in src itself tie the folders together: they may import all. */
function violations(path: string, all: readonly Import[]): string[] {
  if (!path.includes('/')) return []
  const folder = roomOf(path)
  const rule = rules[folder]
  const [outer, inner, more] = path.split('/')
  const isRoom = more !== undefined && ['lab', 'panels'].includes(outer!) && folder === outer
  if (!rule || isRoom)
    return [`src/${isRoom ? `${outer}/${inner}` : folder} has no rule: give it one in this test`]
  return all
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
