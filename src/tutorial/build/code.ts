import { attributes, escaped } from '../still/html.ts'
import { textPlaceOf } from './book.ts'
import type { Env } from './book.ts'
import { languages } from './highlight.ts'
import type { TextFile } from './materials.ts'
import { instead } from './problem.ts'

/** What a file's ending says about its language. */
const endings: Readonly<Record<string, string>> = {
  ts: 'ts',
  cpp: 'cpp',
  cs: 'csharp',
  gd: 'gdscript',
}

/** How the languages of the take-home files are called in tabs. */
const names: Readonly<Record<string, string>> = {
  ts: 'TypeScript',
  cpp: 'C++ (Unreal)',
  cs: 'C# (Unity)',
  gd: 'GDScript (Godot)',
}

/** A listing, and what it is called when it has to be scrolled. */
function listing(html: string, label: string): string {
  return `<pre${attributes({ 'data-label': label })}><code>${html}</code></pre>`
}

/** A fenced block in a language. */
export function codeHtml(env: Env, code: string, language: string, line: number): string {
  if (!(languages as readonly string[]).includes(language)) {
    const known = [...languages, 'figure', 'source', 'take-home', 'hard-cases']
    env.book.report(
      textPlaceOf(env, line),
      `“${language}” is no kind of block${instead(language, known)}`,
    )
    return ''
  }
  const text = code.replace(/\n$/, '')
  return `<div class="code">${listing(env.highlight(text, language), 'Code')}</div>\n`
}

/** Some lines of the project itself, `path#region`, with the path below them, and a caption if there is one. */
export function sourceHtml(env: Env, address: string, caption: string, line: number): string {
  const [path = '', region] = address.split('#')
  const place = textPlaceOf(env, line)
  const source = env.book.materials.read(path)
  if (source === undefined) {
    env.book.report(place, `there is no file ${path}`)
    return ''
  }
  const code = regionOf(source, region)
  if (code === undefined) {
    env.book.report(
      place,
      `${path} has no region “${region}”${instead(region!, regionsOf(source))}`,
    )
    return ''
  }
  const language = endings[path.split('.').at(-1)!] ?? 'ts'
  return `<figure class="code">${listing(env.highlight(code, language), `From ${path}`)}
<figcaption>${pathHtml(path)}${caption && ` <div>${caption}</div>`}</figcaption></figure>\n`
}

/** The take-home steps in all their languages. The page's script turns the headings into tabs. */
export function takeHomeHtml(env: Env, line: number): string {
  const { takeHome } = env.book.materials
  if (takeHome.length === 0)
    env.book.report(textPlaceOf(env, line), 'there are no files in src/tutorial/take-home')
  const is3d = ({ path }: TextFile) => /3d\.\w+$/i.test(path)
  const files = [...takeHome.filter((file) => !is3d(file)), ...takeHome.filter(is3d)]
  const parts = files.map((file) => {
    const ending = file.path.split('.').at(-1)!
    const dimensions = is3d(file) ? '3D' : '2D'
    const name = `${names[ending] ?? ending}, ${dimensions}`
    const code = env.highlight(regionOf(file.text) ?? '', endings[ending] ?? 'ts')
    const id = `take-home-${ending}${is3d(file) ? '-3d' : ''}`
    return `<div class="code" id="${id}">
<p class="tab">${escaped(name)}</p>
${listing(code, `The step in ${name}`)}
<p class="path">${pathHtml(file.path)}</p></div>`
  })
  return `<div class="take-home">\n${parts.join('\n')}\n</div>\n`
}

/** What may come before `#region name` and `#endregion`: the comment signs of the languages. */
const sign = String.raw`^\s*(?:\/\/|#|--)?\s*`
const begins = new RegExp(`${sign}#region\\s+([\\w-]+)\\s*$`)
const ends = new RegExp(`${sign}#endregion\\b`)

/** The names of the regions that a source has. */
function regionsOf(source: string): string[] {
  return source.split('\n').flatMap((line) => begins.exec(line)?.[1] ?? [])
}

/**
 * The lines of a source between `#region name` and its `#endregion`, moved to the left edge; without a name all of it.
 * The lines that mark regions are left out. Undefined where there is no such region, or where it has no end.
 */
function regionOf(source: string, name?: string): string | undefined {
  const lines: string[] = []
  /** How many regions are open within the wanted one, itself included. */
  let depth = name === undefined ? 1 : 0
  let found = depth > 0
  for (const line of source.split('\n')) {
    const begun = begins.exec(line)?.[1]
    if (begun !== undefined) {
      if (depth > 0) depth++
      else if (begun === name && !found) {
        found = true
        depth = 1
      }
    } else if (ends.test(line)) {
      if (depth > 0 && (name !== undefined || depth > 1)) depth--
    } else if (depth > 0) lines.push(line)
  }
  const isWhole = name === undefined || depth === 0
  return found && isWhole ? dedented(lines).trim() : undefined
}

/** Without the spaces that all lines begin with, and without empty lines around. */
function dedented(lines: readonly string[]): string {
  const indents = lines.filter((line) => line.trim()).map((line) => line.search(/\S/))
  const indent = Math.min(...indents)
  // A final newline after the trim in `regionOf` would be a line more on the page.
  return lines
    .map((line) => line.slice(indent))
    .join('\n')
    .replace(/^\n+/, '')
}

/** A path that breaks between its names where it breaks: Safari knows no place in it. */
function pathHtml(path: string): string {
  return `<code>${escaped(path).replaceAll('/', '/<wbr>')}</code>`
}
