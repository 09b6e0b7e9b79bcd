import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { dirname, join } from 'node:path'
import { drawDiagrams } from './diagrams/index.ts'
import type { Tell } from './measure.ts'
import { reportProblems } from './schema/index.ts'
import type { Report } from './schema/index.ts'
import { targets } from './targets.ts'
import { benchmarksFile, benchmarksPage } from './text/benchmarks.ts'
import { formatted } from './text/markdown.ts'

const folder = 'public/report'

/** The report that was written last. */
export function readReport(): Report {
  return JSON.parse(readFileSync(join(process.cwd(), folder, 'report.json'), 'utf8')) as Report
}

/**
 * Writes `public/report`, the numbers and the diagrams, and `docs/benchmarks.md`.
 *
 * @param root the folder that both go into: the project's
 * @throws Error if what was measured is not a report
 */
export async function writeReport(
  measured: Omit<Report, 'diagrams'>,
  tell: Tell,
  root = process.cwd(),
): Promise<void> {
  const tidy = rounded(measured)
  // Anew from the tidy figures, so that they follow from what is published.
  const figures = { ...tidy, targets: rounded(targets(tidy)) }
  const drawings = drawDiagrams(figures)
  const report: Report = { ...figures, diagrams: drawings.map(({ about }) => about) }
  const problems = reportProblems(report)
  if (problems.length > 0) throw new Error(`Not a report:\n${problems.join('\n')}`)
  const json = `${folder}/report.json`
  const files = {
    ...Object.fromEntries(drawings.map(({ about, svg }) => [`${folder}/${about.file}`, svg])),
    [json]: await formatted(JSON.stringify(report), json),
    [benchmarksFile]: await benchmarksPage(report),
  }
  for (const [file, text] of Object.entries(files)) {
    mkdirSync(dirname(join(root, file)), { recursive: true })
    writeFileSync(join(root, file), text)
  }
  for (const { label, figure, met } of report.targets)
    tell(`${met ? 'met   ' : 'missed'}  ${label}: ${figure.toPrecision(3)}`)
}

/** These stay as they are: runs can be repeated and positions compared from them. */
const exact = new Set(['position', 'truth', 'parameters', 'duration', 'setting'])

/** Rounds values to five digits, more than their accuracy. */
export function rounded<T>(value: T): T {
  return tidy(value) as T
}

function tidy(value: unknown): unknown {
  if (typeof value === 'number') return Number(value.toPrecision(5))
  if (Array.isArray(value)) return value.map(tidy)
  if (typeof value !== 'object' || value === null) return value
  return Object.fromEntries(
    Object.entries(value).map(([key, each]) => [key, exact.has(key) ? each : tidy(each)]),
  )
}
