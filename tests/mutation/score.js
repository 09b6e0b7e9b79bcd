/*
 * What mutation testing has found so far: counts by file, and every survivor that equivalents.json does not list. Run by
 * `npm run mutate` at its end, and alone by `node tests/mutation/score.js`, or `… score.js 7` for a sample of one in
 * seven. Writes result.json once every file, or the sample, is measured. Fails while a survivor is not listed, while one is
 * listed that tests do find, and below a score of 90 %.
 */
import { readFileSync, readdirSync, writeFileSync } from 'node:fs'
import { join, resolve } from 'node:path'
import ts from 'typescript'

const root = resolve(import.meta.dirname, '../..')
const physics = join(root, 'src/physics')
const cache = join(root, 'node_modules/.cache/mutation/incremental.json')
const read = (path) => readFileSync(path, 'utf8')

/** What Stryker is given in place of a source file: `as const` keeps it from what stands before. */
export const mutable = (source) => source.replaceAll(/ as const\b/g, '')

/** Whether there is something to mutate: more than types and lists of what is exported. */
function hasCode(source) {
  const { outputText } = ts.transpileModule(source, {
    compilerOptions: { target: ts.ScriptTarget.ESNext, removeComments: true },
  })
  return outputText.replaceAll(/^export \{[^}]*\}.*$/gm, '').trim() !== ''
}

const equivalents = JSON.parse(read(join(import.meta.dirname, 'equivalents.json')))

/** What the list says of a mutant: in that file, on a line of that text, with that replacement where one is named. */
const listed = (name, line, replacement) =>
  equivalents.find(
    (each) =>
      each.file === name &&
      line.includes(each.line) &&
      (each.becomes === undefined || each.becomes.includes(replacement)),
  )

function score(every) {
  const report = JSON.parse(read(cache))
  const total = { killed: 0, timeout: 0, equivalent: 0, survived: 0 }
  const files = {}
  const unlisted = []
  const unmeasured = []
  const [found, survived] = [new Set(), new Set()]
  for (const name of readdirSync(physics, { recursive: true, encoding: 'utf8' }).sort()) {
    if (!name.endsWith('.ts')) continue
    const measured = report.files[`src/physics/${name}`]
    const source = mutable(read(join(physics, name)))
    if (!measured && !hasCode(source)) continue
    if (!measured || (every === 1 && measured.source !== source)) {
      unmeasured.push(name)
      continue
    }
    const lines = measured.source.split('\n')
    const counts = { killed: 0, timeout: 0, equivalent: 0, survived: 0 }
    for (const { status, location, mutatorName, replacement } of measured.mutants) {
      if (status === 'Ignored' || status === 'CompileError' || status === 'RuntimeError') continue
      const line = lines[location.start.line - 1].trim()
      const entry = listed(name, line, replacement)
      const isFound = status === 'Killed' || status === 'Timeout'
      if (entry) (isFound ? found : survived).add(entry)
      if (isFound) counts[status.toLowerCase()]++
      else if (entry) counts.equivalent++
      else {
        counts.survived++
        unlisted.push(
          `${name}:${location.start.line}:${location.start.column} ${status} ${mutatorName}\n  ${line}\n  → ${replacement}`,
        )
      }
    }
    if (Object.values(counts).every((count) => count === 0)) continue
    files[name] = counts
    for (const key of Object.keys(total)) total[key] += counts[key]
  }
  const all = total.killed + total.timeout + total.equivalent + total.survived
  const percent = Math.floor((1000 * (total.killed + total.timeout)) / all) / 10
  const stale = [...found].filter((each) => !survived.has(each))
  return { percent, total, all, files, unlisted, unmeasured, stale }
}

/**
 * Prints and writes the score; returns whether it is good.
 *
 * @param every which part of the functions was asked about: one in so many
 */
export function tell(every = 1) {
  const { percent, total, all, files, unlisted, unmeasured, stale } = score(every)
  console.table(files)
  const survivors = total.equivalent + total.survived
  for (const each of unlisted) console.log(each)
  for (const { file, line } of stale)
    console.log(`Listed, but found by the tests: ${file}: ${line}`)
  if (unmeasured.length > 0 && every === 1)
    console.log(`Not measured as they are now: ${unmeasured.join(', ')}`)
  console.log(
    `${percent} % of ${all} mutants found; ${survivors} survivors, of which ${total.equivalent} are listed as equivalent, ${total.survived} are not.`,
  )
  const result = {
    measured: new Date().toISOString().slice(0, 10),
    every,
    percent,
    mutants: all,
    ...total,
    files,
  }
  // A run over a few files does not replace the result of all, or of a sample of all.
  if (unmeasured.length === 0 || every > 1)
    writeFileSync(join(import.meta.dirname, 'result.json'), `${JSON.stringify(result, null, 2)}\n`)
  return percent >= 90 && unlisted.length === 0 && stale.length === 0
}

if (process.argv[1] === import.meta.filename)
  process.exitCode = tell(Number(process.argv[2] ?? 1)) ? 0 : 1
