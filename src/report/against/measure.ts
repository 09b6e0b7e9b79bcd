import { pathToFileURL } from 'node:url'
import type { IntegratorId } from '../../physics/index.ts'
import { trials } from '../bare/trials.ts'
import { meetEverything } from '../steps.ts'
import { median, ratioOf, timeRounds } from '../timing/rounds.ts'
import type { Care } from '../timing/rounds.ts'
import { framing, simulating } from './works.ts'
import type { Physics } from './works.ts'

/** What is compared: one pair in a process of its own, or every pair in a process that has run everything. */
export type Kind = 'ramp' | 'half-pipe' | 'mixed' | 'simulate'

/** Processor time for a step or a frame [ns], and the median of the ratios of interleaved slices. */
export interface Compared {
  what: string
  ours: number
  other: number
  ratio: number
}

const care: Care = { rounds: 41, atLeast: 20, warming: 200 }
const careMixed: Care = { rounds: 15, atLeast: 20, warming: 60 }

/** Compares two bundled physics modules in this process. */
export async function compareModules({
  kind,
  files,
}: {
  kind: Kind
  files: [ours: string, other: string]
}): Promise<Compared[]> {
  const both = (await Promise.all(files.map((file) => import(pathToFileURL(file).href)))) as [
    Physics,
    Physics,
  ]
  const compare = (
    scene: string,
    integrator: IntegratorId,
    work: typeof framing = framing,
  ): Compared => {
    const trial = trials.find((each) => each.scene === scene && each.kind === 'moves')!
    const [ours, other] = timeRounds(
      both.map((physics) => work(physics, trial, integrator)),
      kind === 'mixed' ? careMixed : care,
    ) as [number[], number[]]
    return {
      what: `${scene}, ${integrator}`,
      ours: median(ours),
      other: median(other),
      ratio: ratioOf(ours, other),
    }
  }
  if (kind === 'ramp') return [compare('ramp', 'velocity-verlet')]
  if (kind === 'half-pipe') return [compare('half-pipe', 'rk4')]
  if (kind === 'simulate') return [compare('ramp', 'velocity-verlet', simulating)]
  for (const physics of both) meetEverything(physics)
  const scenes = [...new Set(trials.map(({ scene }) => scene))]
  return scenes.flatMap((scene) => both[0].integrators.map(({ id }) => compare(scene, id)))
}
