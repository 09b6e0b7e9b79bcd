import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Experiment } from '../physics/index.ts'
import { peers } from './peers/index.ts'
import type { Contestant } from './schema.ts'

/** Our own rows: what this project is for, and what it starts from. */
export const ours = [
  {
    id: 'located',
    label: 'This project',
    setup:
      'velocity Verlet, located stops. Errors with a step a frame; time of a step with 60 of them in a call of `run.frame`, as a game with substeps or a replay calls it.',
    method: { integrator: 'velocity-verlet', stopping: 'located' },
  },
  {
    id: 'paper',
    label: 'The paper’s step',
    setup: 'this project with semi-implicit Euler and naive friction, a step a frame.',
    method: { integrator: 'semi-implicit-euler', stopping: 'naive' },
  },
] as const satisfies readonly (Omit<Contestant, 'version'> & { method: Partial<Experiment> })[]

/** The first of ours once more, called as a game calls it: only its time differs. */
export const frameByFrame = {
  id: 'frame-by-frame',
  label: 'This project, frame by frame',
  setup:
    'the same, with a call of `run.frame` for each step, as a game with a step a frame calls it.',
} as const

/** Everybody in the report, with the version that is installed. */
export function contestants(): Contestant[] {
  const version = versionOf('.')
  return [
    ...ours.map(({ id, label, setup }) => ({ id, label, version, setup })),
    { ...frameByFrame, version },
    ...peers.map((peer) => ({
      id: peer.id,
      label: peer.id,
      version: versionOf(`node_modules/${peer.package}`),
      setup: peer.setup,
    })),
    {
      id: 'odex',
      label: 'odex',
      version: versionOf('node_modules/odex'),
      setup:
        'extrapolation (Gragg, Bulirsch and Stoer) that chooses its own steps, relative and absolute tolerance alike; no dense output.',
    },
  ]
}

function versionOf(folder: string): string {
  const { version } = JSON.parse(
    readFileSync(join(process.cwd(), folder, 'package.json'), 'utf8'),
  ) as { version: string }
  return version
}
