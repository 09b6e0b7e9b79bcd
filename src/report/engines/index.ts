import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Experiment } from '../../physics/index.ts'
import type { EngineInfo } from '../schema/index.ts'
import { box2d } from './box2d.ts'
import { matter } from './matter.ts'
import type { Engine } from './engine.ts'
import { planck } from './planck.ts'
import { rapier } from './rapier.ts'

/** What people would use instead. */
export const engines: readonly Engine[] = [matter, planck, rapier, box2d]

export type { EngineBlock, Engine, EngineSlope } from './engine.ts'

/** Our own rows: what this project is for, and what it starts from. */
export const ours = [
  {
    id: 'located',
    label: 'This project',
    setup: 'velocity Verlet, located stops, a call of `run.frame` for each step.',
    method: { integrator: 'velocity-verlet', stopping: 'located' },
  },
  {
    id: 'paper',
    label: 'The paper’s step',
    setup: 'this project with semi-implicit Euler and naive friction, a step a frame.',
    method: { integrator: 'semi-implicit-euler', stopping: 'naive' },
  },
] as const satisfies readonly (Omit<EngineInfo, 'version'> & { method: Partial<Experiment> })[]

/** Rows that only have a time. */
export const recorded = {
  id: 'simulate',
  label: 'This project, simulate',
  setup: 'the same, ten thousand frames in one call of `simulate`, which records each of them.',
} as const
export const byHand = {
  id: 'handwritten',
  label: 'Handwritten loop',
  setup:
    'velocity Verlet for this one scene, with the same duties: located stops, heat, exact time. It is in `src/report/handwritten`.',
} as const

/** Everything that the report compares, with the version that is installed. */
export function engineList(): EngineInfo[] {
  const version = versionOf('.')
  return [
    ...[...ours, recorded, byHand].map(({ id, label, setup }) => ({ id, label, version, setup })),
    ...engines.map((engine) => ({
      id: engine.id,
      label: engine.id,
      version: versionOf(`node_modules/${engine.package}`),
      setup: engine.setup,
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
