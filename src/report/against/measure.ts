import { pathToFileURL } from 'node:url'
import { integrators } from '../../physics/index.ts'
import type { IntegratorId } from '../../physics/index.ts'
import { handwritten, looping } from '../handwritten/index.ts'
import { median, ratioOf, timeRounds } from '../timing/rounds.ts'
import type { Care } from '../timing/rounds.ts'
import { timed, timedScenes, trial } from '../timing/trials.ts'
import type { TimedScene } from '../timing/trials.ts'
import type * as worksModule from '../timing/works.ts'

/**
 * What is compared: one scene and method in a process of its own, or all of them in a process that has run everything.
 */
export type Kind = 'ramp' | 'half-pipe' | 'mixed' | 'simulate'

/**
 * Processor time for a frame [ns], and medians of the ratios of slices of the same round; null: there is no such loop.
 */
export interface Compared {
  scene: string
  integrator: string
  ours: number
  other: number
  ratio: number
  handwritten: number | null
  handwrittenRatio: number | null
}

/** Compares two bundles of `works.ts` in this process. */
export async function compareBundles({
  kind,
  files,
  care,
}: {
  kind: Kind
  files: readonly [ours: string, other: string]
  care: Care
}): Promise<Compared[]> {
  const [ours, other] = await Promise.all(files.map(load))
  const both = [ours!, other!]
  if (kind === 'ramp') return [compare(both, 'ramp', 'velocity-verlet', care)]
  if (kind === 'half-pipe') return [compare(both, 'half-pipe', 'rk4', care)]
  if (kind === 'simulate') return [compareSimulate(both, care)]
  for (const works of both) works.runEverything()
  return timedScenes.flatMap((scene) => integrators.map(({ id }) => compare(both, scene, id, care)))
}

type Works = typeof worksModule

async function load(file: string): Promise<Works> {
  return (await import(pathToFileURL(file).href)) as Works
}

function compare(
  both: readonly Works[],
  scene: TimedScene,
  integrator: IntegratorId,
  care: Care,
): Compared {
  const experiment = trial(scene, integrator)
  const loop = handwritten.find((each) => each.scene === scene && each.integrator === integrator)
  const [ours, other, byHand] = timeRounds(
    [
      ...both.map((works) => works.framing(experiment, timed)),
      ...(loop ? [looping(() => loop.start(experiment.parameters), timed)] : []),
    ],
    care,
  )
  return {
    scene,
    integrator,
    ...ratioed(ours!, other!),
    handwritten: byHand ? median(byHand) : null,
    handwrittenRatio: byHand ? ratioOf(ours!, byHand) : null,
  }
}

function compareSimulate(both: readonly Works[], care: Care): Compared {
  const [scene, integrator] = ['ramp', 'velocity-verlet'] as const
  const experiment = trial(scene, integrator)
  const [ours, other] = timeRounds(
    both.map((works) => works.simulating(experiment, timed.steps)),
    care,
  )
  return {
    scene,
    integrator,
    ...ratioed(ours!, other!),
    handwritten: null,
    handwrittenRatio: null,
  }
}

function ratioed(ours: readonly number[], other: readonly number[]) {
  return { ours: median(ours), other: median(other), ratio: ratioOf(ours, other) }
}
