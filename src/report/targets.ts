import { integrators, scenes } from '../physics/index.ts'
import { ours, engines } from './engines/index.ts'
import type { FrameTime, Report, Target } from './schema/index.ts'
import { inMetres } from './text/numbers.ts'

type Measured = Pick<Report, 'frames' | 'engineTests' | 'frontiers'>
type Found = Pick<Target, 'figure' | 'from'> | undefined

/** One boxed number a step takes 12 bytes and more; less than this is what the engine itself takes now and then. */
const NOTHING = 1

/** What was asked for, and what came out. Targets without a figure, because something could not be run, are left out. */
export function targets({ frames, engineTests, frontiers }: Measured): Target[] {
  const found: (Target | undefined)[] = [
    target(
      ['alone', 'A call of run.frame a step, alone: times the handwritten loop'],
      ['at most', 2.5],
      worst(frames, ({ ratios }) => ratios.alone),
    ),
    target(
      ['mixed', 'A call of run.frame a step, after everything else: times the handwritten loop'],
      ['at most', 2.5],
      worst(frames, ({ ratios }) => ratios.mixed),
    ),
    target(
      ['bytes-alone', 'Bytes that a call allocates, alone'],
      ['at most', NOTHING],
      worst(frames, ({ bytes }) => bytes.alone),
    ),
    target(
      ['bytes-mixed', 'Bytes that a call allocates, after everything else'],
      ['at most', NOTHING],
      worst(frames, ({ bytes }) => bytes.mixed),
    ),
    target(
      ['engines-time', 'Time of a step of the fastest engine, divided by a call of run.frame'],
      ['at least', 100],
      fastestEngine(engineTests),
    ),
    target(
      ['engines-error', 'Error of the best engine at 10 fps, divided by ours'],
      ['at least', 1e9],
      bestEngine(engineTests),
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
            `Half-pipe to ${inMetres(error)}: ${cost} of odex, divided by ours`,
          ],
          ['at least', 1],
          best && odex ? { figure: odex[cost] / best[cost], from: best.label } : undefined,
        ),
      )
  }
  return found.filter((each) => each !== undefined)
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

/** The largest figure, and whose it is. */
function worst(frames: readonly FrameTime[], figure: (frame: FrameTime) => number | null): Found {
  let most: Found
  for (const frame of frames) {
    const value = figure(frame)
    if (value !== null && (!most || value > most.figure))
      most = { figure: value, from: nameOf(frame) }
  }
  return most
}

function nameOf({ scene, integrator }: FrameTime): string {
  return [labelOf(scenes, scene), labelOf(integrators, integrator)].join(', ')
}

function labelOf(list: readonly { id: string; label: string }[], id: string): string {
  return list.find((each) => each.id === id)!.label
}

function fastestEngine({ times }: Report['engineTests']): Found {
  const [fastest] = times
    .filter(({ engine }) => engines.some(({ id }) => id === engine))
    .sort((a, b) => a.ratio - b.ratio)
  return fastest && { figure: fastest.ratio, from: fastest.engine }
}

/**
 * The scene in which the best engine comes nearest to us. Scenes in which it makes no error at all, because nothing
 * moves, say nothing. What of ours is below one rounding of the distance counts as one rounding.
 */
function bestEngine({ scenes, runs }: Report['engineTests']): Found {
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
