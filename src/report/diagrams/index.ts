import type { Report } from '../schema/index.ts'
import type { DiagramDrawing } from './draw.ts'
import { engineErrorsDiagram, engineTimesDiagram } from './engines.ts'
import { frontierDiagram } from './frontier.ts'

/** Every diagram of a report. */
export function drawDiagrams(report: Omit<Report, 'diagrams'>): DiagramDrawing[] {
  return [
    ...report.frontiers.flatMap((each) => [
      frontierDiagram(each, 'time'),
      frontierDiagram(each, 'evaluations'),
    ]),
    engineTimesDiagram(report),
    engineErrorsDiagram(report),
  ]
}
