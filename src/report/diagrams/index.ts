import type { Report } from '../schema/index.ts'
import type { Drawing } from './draw.ts'
import { engineErrorsDiagram, engineTimesDiagram } from './engines.ts'
import { frontierDiagram } from './frontier.ts'

/** Every diagram of a report. */
export function drawDiagrams(report: Omit<Report, 'diagrams'>): Drawing[] {
  return [
    ...report.frontiers.flatMap((each) => [
      frontierDiagram(each, 'time'),
      frontierDiagram(each, 'evaluations'),
    ]),
    engineTimesDiagram(report),
    engineErrorsDiagram(report),
  ]
}
