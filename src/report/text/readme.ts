import type { Report } from '../schema/index.ts'
import { formatted } from './formatted.ts'
import { markdownTable } from './markdown.ts'
import {
  cheapestWays,
  engineErrors,
  engineTimes,
  frameTable,
  measuredOn,
  oddities,
  targetTable,
} from './tables.ts'
import type { Table } from './tables.ts'

/** What stands between `<!-- report:name -->` and `<!-- /report:name -->`. */
const parts: Readonly<Record<string, (report: Report) => string>> = {
  machine: measuredOn,
  diagrams: ({ diagrams }) =>
    diagrams
      .map(({ file, description }) => `![${description}](public/report/${file})`)
      .join('\n\n'),
  frontier: (report) => titled(cheapestWays(report)),
  'engine-errors': (report) => titled(engineErrors(report)),
  'engine-oddities': (report) => bullets(oddities(report)),
  'engine-times': (report) => titled(engineTimes(report)),
  setups: ({ engines }) => bullets(engines.map(({ label, setup }) => `${label}: ${setup}`)),
  frames: (report) => titled(frameTable(report)),
  targets: (report) => titled(targetTable(report)),
  'not-run': ({ notRun }) =>
    notRun.length === 0
      ? 'Everything could be run.'
      : bullets(notRun.map(({ what, why }) => `${what}: ${why}`)),
}

/**
 * README with the report's figures in their places, formatted as the project formats it.
 *
 * @throws Error for a marker without its end or with a name that is not known
 */
export async function withReport(readme: string, report: Report): Promise<string> {
  const filled = readme.replace(
    /<!-- report:([\w-]+) -->[^]*?<!-- \/report:([\w-]+) -->/g,
    (_, name: string, end: string) => {
      const part = parts[name]
      if (!part || end !== name) throw new Error(`README: report:${name} … /report:${end}`)
      return `<!-- report:${name} -->\n\n${part(report)}\n\n<!-- /report:${name} -->`
    },
  )
  return formatted(filled, 'README.md')
}

function titled({ title, head, rows }: Table): string {
  return `_${title}_\n\n${markdownTable(head, rows)}`
}

function bullets(lines: readonly string[]): string {
  return lines.map((line) => `- ${line}`).join('\n')
}
