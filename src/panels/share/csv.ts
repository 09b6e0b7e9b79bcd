import type { ExactMotion } from '../../physics/index.ts'
import { errorAt } from '../../lab/state/simulation.ts'
import type { SimulatedRunner } from '../../lab/state/simulation.ts'

/**
 * The trajectories of some runners as comma-separated values: a header with units, then a row for every frame of each
 * runner. Numbers are written in full, so that the same bits are read back.
 */
export function toCsv(runners: readonly SimulatedRunner[], exact: ExactMotion): string {
  const lines = [columns.map(([heading]) => quoted(heading)).join(',')]
  for (const runner of runners)
    for (let row = 0; row <= runner.trajectory.frames; row++)
      lines.push(columns.map(([, value]) => value(runner, row, exact)).join(','))
  // Line ends as RFC 4180 has them.
  return lines.join('\r\n') + '\r\n'
}

type ColumnValue = (runner: SimulatedRunner, row: number, exact: ExactMotion) => string | number

const columns: readonly (readonly [string, ColumnValue])[] = [
  ['runner', ({ name }) => quoted(name)],
  ['frame', (_, row) => row],
  ['time (s)', ({ trajectory }, row) => trajectory.time[row]!],
  ['state time (s)', ({ trajectory }, row) => trajectory.stateTime[row]!],
  ['s (m)', ({ trajectory }, row) => trajectory.s[row]!],
  ['v (m/s)', ({ trajectory }, row) => trajectory.v[row]!],
  ['drawn s (m)', ({ trajectory }, row) => trajectory.drawnS[row]!],
  ['exact s (m)', ({ trajectory }, row, exact) => exact(trajectory.time[row]!, { s: 0, v: 0 }).s],
  ['error (m)', ({ trajectory }, row, exact) => errorAt(trajectory, exact, row)],
  ['heat (J)', ({ trajectory }, row) => trajectory.heat[row]!],
]

function quoted(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text
}
