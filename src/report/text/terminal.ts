import type { Report } from '../schema/index.ts'
import { plainTable } from './markdown.ts'
import {
  cheapestWays,
  controlledWays,
  engineErrors,
  engineTimes,
  frameTable,
  measuredOn,
  oddities,
  targetTable,
} from './tables.ts'

/** The whole report for somebody at a terminal. */
export function terminalText(report: Report): string {
  const tables = [
    engineTimes(report),
    frameTable(report),
    ...report.engineTests.clocks.map((clock) => engineErrors(report, [clock])),
    cheapestWays(report),
    controlledWays(report),
    targetTable(report),
  ]
  const lists = [
    ['Odd runs', oddities(report)],
    ['Not run', report.notRun.map(({ what, why }) => `${what}: ${why}`)],
  ] as const
  return [
    measuredOn(report),
    ...tables.map(({ title, head, rows }) => `${title}\n${plainTable(head, rows)}`),
    ...lists
      .filter(([, lines]) => lines.length > 0)
      .map(([title, lines]) => [title, ...lines.map((line) => `  ${line}`)].join('\n')),
  ].join('\n\n')
}
