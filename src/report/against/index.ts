import { resolve } from 'node:path'
import { inChild } from '../child.ts'
import { plainTable } from '../text/markdown.ts'
import { bundlePhysics } from './bundle.ts'
import type { Compared, Kind } from './measure.ts'

const headings: Readonly<Record<Kind, string>> = {
  ramp: 'run.frame, one step a call, alone',
  'half-pipe': 'run.frame, one step a call, alone',
  mixed: 'run.frame, one step a call, after running everything',
  simulate: 'simulate, ten thousand frames',
}

/**
 * Compares the processor time of this checkout's physics module with another's, interleaved in one process for each kind of
 * work, and returns the tables.
 */
export async function compareCheckouts(other: string, tell: (what: string) => void) {
  const files = [
    await bundlePhysics(process.cwd(), 'ours'),
    await bundlePhysics(resolve(other), 'other'),
  ] as [string, string]
  const found: [Kind, Compared[]][] = []
  for (const kind of Object.keys(headings) as Kind[]) {
    tell(kind)
    found.push([kind, await inChild('against', { kind, files })])
  }
  return found.map(([kind, rows]) => `${headings[kind]}\n${table(rows)}`).join('\n\n')
}

function table(rows: readonly Compared[]): string {
  const worst = rows.reduce((most, row) => (row.ratio > most.ratio ? row : most))
  const all = rows.length > 1 ? [...rows, { ...worst, what: `worst: ${worst.what}` }] : rows
  return plainTable(
    ['', 'ours', 'other', 'ratio'],
    all.map(({ what, ours, other, ratio }) => [
      what,
      `${ours.toFixed(1)} ns`,
      `${other.toFixed(1)} ns`,
      ratio.toFixed(3),
    ]),
  )
}
