import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { dirname, join, normalize } from 'node:path'
import { describe, expect, test } from 'vitest'
import { modes } from '../../src/lab/state/modes.ts'
import { hardCases } from '../../src/measure/index.ts'
import { engines } from '../../src/report/engines/index.ts'
import { root } from './extending.ts'

/* What the documents say of the project, compared with the project. */

const names = [
  ...['README.md', 'CONTRIBUTING.md', 'CHANGELOG.md'],
  ...readdirSync(join(root, 'docs'))
    .filter((name) => name.endsWith('.md'))
    .map((name) => `docs/${name}`),
]

function read(name: string): string {
  return readFileSync(join(root, name), 'utf8')
}

/** The anchors that GitHub gives the headings of a text. */
function anchors(markdown: string): string[] {
  const headings = [...withoutCode(markdown).matchAll(/^#+ (.+)$/gm)]
  return headings.map(([, heading]) =>
    heading!
      .toLowerCase()
      .replace(/[^\p{L}\p{N}\s_-]/gu, '')
      .replace(/\s/g, '-'),
  )
}

function withoutCode(markdown: string): string {
  return markdown.replace(/```[^]*?```/g, '')
}

/** The links of a text, and its definitions of links, that lead to a file or a heading of the project. */
function links(markdown: string): string[] {
  const found = withoutCode(markdown).matchAll(/\]\(([^)\s]+)\)|^\[[^\]]+\]: (\S+)$/gm)
  return [...found]
    .map(([, inline, defined]) => (inline ?? defined)!)
    .filter((to) => !/^\w+:/.test(to))
}

/** What is wrong with a link of a document. */
function problem(name: string, link: string): string | undefined {
  const [path, anchor] = link.split('#') as [string, string?]
  const target = path === '' ? name : normalize(join(dirname(name), path)).replaceAll('\\', '/')
  if (!existsSync(join(root, target))) return `${link}: there is no ${target}`
  if (anchor !== undefined && !anchors(read(target)).includes(anchor))
    return `${link}: ${target} has no such heading`
  return undefined
}

/** Whether a path leads to something; a star in the last part stands for anything. */
function leads(path: string): boolean {
  if (!path.includes('*')) return existsSync(join(root, path))
  const pattern = new RegExp(
    `^${path.split('/').at(-1)!.replaceAll('.', '\\.').replaceAll('*', '.*')}$`,
  )
  return readdirSync(join(root, dirname(path))).some((name) => pattern.test(name))
}

describe.each(names)('%s', (name) => {
  const text = read(name)

  test('its links lead to files and headings that are there', () => {
    expect(links(text).flatMap((link) => problem(name, link) ?? [])).toEqual([])
  })

  test('it names only files and commands that are there', () => {
    const paths = [...text.matchAll(/`((?:src|tests|public|docs)\/[^\s`]*|vite\.[\w.*]+)`/g)]
    expect(paths.map(([, path]) => path!).filter((path) => !leads(path))).toEqual([])
    const { scripts } = JSON.parse(read('package.json')) as { scripts: Record<string, string> }
    const commands = [...text.matchAll(/npm (?:run )?(test\b|start\b|(?<=run )[\w:-]+)/g)]
    expect(commands.map(([, script]) => script!).filter((script) => !(script in scripts))).toEqual(
      [],
    )
  })
})

test('a link to nowhere is found, and so is one to a heading that is not there', () => {
  expect(problem('README.md', 'docs/nothing.md')).toBeDefined()
  expect(problem('README.md', 'docs/model.md#nothing')).toBeDefined()
  expect(problem('docs/promises.md', 'model.md#what-is-promised')).toBeUndefined()
  expect(leads('tests/docs/*.test.ts')).toBe(true)
  expect(leads('tests/docs/*.test.js')).toBe(false)
})

test('every document is linked from README', () => {
  const linked = links(read('README.md'))
  expect(names.filter((name) => name !== 'README.md' && !linked.includes(name))).toEqual([])
})

describe('README', () => {
  const readme = read('README.md')
  const [figure, module] = ['html', 'ts'].map((kind) => {
    const [, code] = new RegExp(`\`\`\`${kind}\\n([^]*?)\`\`\``).exec(readme)!
    return code!.trimEnd().split('\n')
  })

  test('is short: 110 lines, of which a figure takes five and the module ten', () => {
    expect(readme.trimEnd().split('\n').length).toBeLessThanOrEqual(110)
    expect(figure).toHaveLength(5)
    expect(module).toHaveLength(10)
  })

  test('its map shows every room', () => {
    const [, map] = /```\n(src\/[^]*?)```/.exec(readme)!
    const shown = new Set([...map!.matchAll(/\bsrc\/(\w+)\//g)].map(([, room]) => room!))
    expect([...shown].sort()).toEqual(folders('src').sort())
  })

  test('its numbers are right', () => {
    expect(engines).toHaveLength(4)
    expect(readme).toContain('four physics engines')
    const sections = readdirSync(join(root, 'src/tutorial/text')).filter((name) => /^\d/.test(name))
    expect(sections).toHaveLength(11)
    expect(readme).toContain('Eleven short sections')
    expect(modes).toHaveLength(6)
    const [first, last] = [modes[0]!.label, modes.at(-1)!.label]
    expect(readme.replace(/\s+/g, ' ')).toContain(`Six buttons lead from _${first}_ to _${last}_`)
  })
})

function folders(path: string): string[] {
  return readdirSync(join(root, path), { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => name)
}

describe('docs/architecture.md', () => {
  const text = read('docs/architecture.md')
  const section = (heading: string) => text.split(/^## /m).find((each) => each.startsWith(heading))!
  const firstCells = (heading: string) =>
    [...section(heading).matchAll(/^\| (?!-)([^|]+?) *\|/gm)].map(([, cell]) => cell!).slice(1)

  test('lists every room, and no other', () => {
    const rooms = [
      ...folders('src').map((name) => `src/${name}`),
      ...['lab', 'panels'].flatMap((room) =>
        folders(`src/${room}`).map((name) => `src/${room}/${name}`),
      ),
    ]
    expect(firstCells('Rooms').sort()).toEqual(rooms.map((room) => `\`${room}\``).sort())
  })

  test('lists every folder of the physics', () => {
    const listed = firstCells('Inside physics')
    for (const name of folders('src/physics')) expect(listed).toContain(`\`src/physics/${name}\``)
  })

  test('explains at most twenty words', () => {
    const words = firstCells('Glossary')
    expect(words.length).toBeLessThanOrEqual(20)
    expect(new Set(words).size).toBe(words.length)
  })
})

test('docs/promises.md counts the hard cases', () => {
  const groups = new Set(hardCases.map(({ group }) => group)).size
  expect(read('docs/promises.md')).toContain(`${hardCases.length} hard cases in ${groups} groups`)
})

test('docs/promises.md names for each promise what holds it, and the command', () => {
  const rows = read('docs/promises.md')
    .split('\n')
    .filter((line) => /^\| (?!promise|-)/.test(line))
    .map((line) => line.split('|').map((cell) => cell.trim()))
  expect(rows.length).toBeGreaterThan(20)
  for (const [, promise, holder, command] of rows) {
    expect(holder, promise).toMatch(/^`[^`]+`(, `[^`]+`)*$/)
    expect(command, promise).toMatch(/^`npm (test|run [\w:-]+)`$/)
    if (command === '`npm test`')
      for (const [, file] of holder!.matchAll(/`([^`]+)`/g)) expect(file).toMatch(/\.test\.ts$/)
  }
})

test('docs/embedding.md shows the messages, the package and the policy as they are', () => {
  const text = read('docs/embedding.md')
  const script = read('public/embed-resize.js')
  const messages = [...text.matchAll(/any-frame-rate:\w+/g)].map(([message]) => message)
  expect(new Set(messages).size).toBe(2)
  for (const message of messages) expect(script).toContain(message)
  const { name, version, exports } = JSON.parse(read('package.json')) as {
    name: string
    version: string
    exports: Record<string, unknown>
  }
  expect(text).toContain(`${name}-${version}.tgz`)
  for (const [, module] of text.matchAll(/'any-frame-rate([^':]*)'/g))
    expect(Object.keys(exports)).toContain(`.${module}`)
  const [, policy] = /```\n(default-src[^]*?)\n```/.exec(text)!
  const [, served] = /"(default-src [^"]+)"/.exec(read('tests/site/hosts.ts'))!
  expect(policy!.split('; ').sort()).toEqual(served!.split('; ').sort())
})
