import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { drawDiagrams } from './diagrams/index.ts'
import type { Tell } from './measure.ts'
import { reportProblems } from './schema/index.ts'
import type { Report } from './schema/index.ts'
import { targets } from './targets.ts'
import { formatted } from './text/formatted.ts'
import { withReport } from './text/readme.ts'
import { rounded } from './text/rounded.ts'

const folder = join(process.cwd(), 'public/report')

/** The report that was written last. */
export function readReport(): Report {
  return JSON.parse(readFileSync(join(folder, 'report.json'), 'utf8')) as Report
}

/**
 * Writes `public/report`: the figures and the diagrams; and the tables in README.
 *
 * @throws Error if what was measured is not a report
 */
export async function writeReport(measured: Omit<Report, 'diagrams'>, tell: Tell): Promise<void> {
  const tidy = rounded(measured)
  // Anew from the tidy figures, so that they follow from what is published.
  const figures = { ...tidy, targets: rounded(targets(tidy)) }
  const drawings = drawDiagrams(figures)
  const report: Report = { ...figures, diagrams: drawings.map(({ about }) => about) }
  const problems = reportProblems(report)
  if (problems.length > 0) throw new Error(`Not a report:\n${problems.join('\n')}`)
  mkdirSync(folder, { recursive: true })
  for (const { about, svg } of drawings) writeFileSync(join(folder, about.file), svg)
  const json = await formatted(JSON.stringify(report), 'public/report/report.json')
  writeFileSync(join(folder, 'report.json'), json)
  const readme = join(process.cwd(), 'README.md')
  writeFileSync(readme, await withReport(readFileSync(readme, 'utf8'), report))
  for (const { label, figure, met } of report.targets)
    tell(`${met ? 'met   ' : 'missed'}  ${label}: ${figure.toPrecision(3)}`)
}
