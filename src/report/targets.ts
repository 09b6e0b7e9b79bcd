import { frameByFrame, ours } from './contestants.ts'
import { peers as engines } from './peers/index.ts'
import type { Report, StepTime, Target } from './schema.ts'
import { stepName } from './stepName.ts'
import type { Profiled } from './tasks.ts'
import { metres } from './text/figures.ts'

type Measured = Pick<Report, 'steps' | 'peers' | 'frontiers'>
type Found = Pick<Target, 'figure' | 'from'> | undefined

/** One boxed number a step takes 12 bytes and more; less than this is what the engine itself takes now and then. */
const NOTHING = 1

/** What was asked for, and what came out. Targets without a figure, because something could not be run, are left out. */
export function targets({ steps, peers, frontiers }: Measured): Target[] {
  const found: (Target | undefined)[] = [
    target(
      ['ramp-alone', 'Located Verlet on the ramp, alone: times the hand-written loop'],
      ['at most', 1.5],
      worst(rampSteps(steps), ({ ratios }) => ratios.alone),
    ),
    target(
      [
        'alone',
        'Every method that has a hand-written loop, in every scene, alone: times that loop',
      ],
      ['at most', 1.5],
      worst(steps, ({ ratios }) => ratios.alone),
    ),
    target(
      [
        'mixed',
        'Every method that has a hand-written loop, in every scene, mixed: times that loop',
      ],
      ['at most', 4],
      worst(steps, ({ ratios }) => ratios.mixed),
    ),
    target(
      ['bytes-alone', 'Bytes that a step allocates, alone'],
      ['at most', NOTHING],
      worst(steps, ({ bytes }) => bytes.alone),
    ),
    target(
      ['bytes-mixed', 'Bytes that a step allocates, mixed'],
      ['at most', NOTHING],
      worst(steps, ({ bytes }) => bytes.mixed),
    ),
    target(
      ['recorded', 'simulate, which records every frame, of a moving block: times the same loop'],
      ['at most', 2],
      // A hand-written loop ends where the block rests; a recording goes on.
      worst(
        steps.filter(({ trial }) => trial === 'moves'),
        ({ ratios }) => ratios.recorded,
      ),
    ),
    target(
      ['peers-time', 'Time of a step of the fastest engine, divided by ours'],
      ['at least', 100],
      fastestPeer(peers, ours[0].id),
    ),
    target(
      ['peers-frame', 'The same, with a call of ours for each step'],
      ['at least', 100],
      fastestPeer(peers, frameByFrame.id),
    ),
    target(
      ['peers-error', 'Error of the best engine at 10 fps, divided by ours'],
      ['at least', 1e9],
      bestPeer(peers),
    ),
  ]
  const halfPipe = frontiers.find(({ id }) => id === 'half-pipe')
  for (const { error, fewest, quickest, odex } of halfPipe?.at ?? []) {
    const power = `1e${Math.round(Math.log10(error))}`
    for (const [cost, best] of [
      ['evaluations', fewest],
      ['time', quickest],
    ] as const)
      found.push(
        target(
          [
            `odex-${cost}-${power}`,
            `Half-pipe to ${metres(error)}: ${cost} of odex, divided by ours`,
          ],
          ['at least', 1],
          best && odex ? { figure: odex[cost] / best[cost], from: best.label } : undefined,
        ),
      )
  }
  return found.filter((each) => each !== undefined)
}

/** The scenes and methods to look into: the worst of each ratio that missed. */
export function worthProfiling(steps: readonly StepTime[], checked: readonly Target[]): Profiled[] {
  const missed = (id: string) => checked.some((each) => each.id === id && !each.met)
  const found: Profiled[] = []
  for (const kind of ['alone', 'mixed'] as const)
    if (missed(kind)) {
      const [step] = [...steps].sort((a, b) => (b.ratios[kind] ?? 0) - (a.ratios[kind] ?? 0))
      const { scene, integrator, trial } = step!
      found.push({ scene, integrator, trial, mixed: kind === 'mixed' })
    }
  return found
}

/** What to take apart: the worst recording, and a call a step on the ramp, where these missed. */
export function worthTakingApart(
  steps: readonly StepTime[],
  checked: readonly Target[],
): { task: 'recordingParts' | 'frameParts'; profiled: Profiled }[] {
  const missed = (id: string) => checked.some((each) => each.id === id && !each.met)
  const [worstRecorded] = steps
    .filter(({ trial }) => trial === 'moves')
    .sort((a, b) => b.ratios.recorded - a.ratios.recorded)
  const [onRamp] = rampSteps(steps)
  return [
    ...(missed('recorded') ? [{ task: 'recordingParts', step: worstRecorded! } as const] : []),
    ...(missed('peers-frame') ? [{ task: 'frameParts', step: onRamp! } as const] : []),
  ].map(({ task, step: { scene, integrator, trial } }) => ({
    task,
    profiled: { scene, integrator, trial, mixed: false },
  }))
}

function target(
  [id, label]: [string, string],
  [sense, limit]: [Target['sense'], number],
  found: Found,
): Target | undefined {
  if (!found) return undefined
  const { figure, from } = found
  const met = sense === 'at most' ? figure <= limit : figure >= limit
  return { id, label, sense, limit, figure, met, from }
}

function rampSteps(steps: readonly StepTime[]): StepTime[] {
  return steps.filter(
    ({ scene, integrator }) => scene === 'ramp' && integrator === 'velocity-verlet',
  )
}

/** The largest figure, and whose it is. */
function worst(steps: readonly StepTime[], figure: (step: StepTime) => number | null): Found {
  let most: Found
  for (const step of steps) {
    const value = figure(step)
    if (value !== null && (!most || value > most.figure))
      most = { figure: value, from: stepName(step) }
  }
  return most
}

function fastestPeer({ times }: Report['peers'], own: string): Found {
  const ratio = times.find(({ engine }) => engine === own)?.ratio
  const [fastest] = times
    .filter(({ engine }) => engines.some(({ id }) => id === engine))
    .sort((a, b) => a.ratio - b.ratio)
  return ratio && fastest ? { figure: fastest.ratio / ratio, from: fastest.engine } : undefined
}

/**
 * The scene in which the best engine comes nearest to us. Scenes in which it makes no error at all, because nothing
 * moves, say nothing. What of ours is below one rounding of the distance counts as one rounding.
 */
function bestPeer({ scenes, runs }: Report['peers']): Found {
  let least: Found
  for (const { id, label, truth } of scenes) {
    const at = runs.filter(({ scene, clock }) => scene === id && clock === '10 fps')
    const own = at.find(({ engine }) => engine === ours[0].id)?.error
    const [best] = at
      .filter(({ engine }) => engines.some(({ id }) => id === engine))
      .flatMap(({ engine, error }) => (error === null ? [] : { engine, error }))
      .sort((a, b) => a.error - b.error)
    if (own === undefined || own === null || !best || best.error === 0) continue
    const figure = best.error / Math.max(own, Number.EPSILON * Math.max(1, Math.abs(truth)))
    if (!least || figure < least.figure) least = { figure, from: `${best.engine}, ${label}` }
  }
  return least
}
