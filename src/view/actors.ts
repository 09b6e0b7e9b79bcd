import { clamp } from '../chart/geometry.ts'
import type { DrawnBody } from './body.ts'
import { exactExtent } from './extent.ts'
import type { Layout } from './layout.ts'
import type { Picture, PictureRunner } from './picture.ts'
import type { Projection } from './projection.ts'
import { viewOf } from './scenes.ts'
import { endOf, rowAt } from './timeline.ts'
import type { End } from './timeline.ts'

/** A block as it stands at the picture's time. */
export interface Actor {
  readonly body: DrawnBody
  /** Its distance from the start [m]. */
  readonly distance: number
  /** Where it is when the run is over, on the part of the track that is seen [m]. */
  readonly last: number
  /** Which end of the picture it has run out of, if it has: −1 that of small s. */
  readonly beyond: -1 | 0 | 1
  /** Which row of its run is shown; of the exact one none. */
  readonly row?: number | undefined
  /** How its run has ended by now, if it has. */
  readonly end?: End | undefined
  /** When it will come to rest, if it will [s]. */
  readonly restsAt?: number | undefined
  /** Undefined: the exact one. */
  readonly runner?: PictureRunner
}

/** All runners at the picture's time, and the exact block as the last one. */
export function actorsOf(picture: Picture, layout: Layout, projection: Projection): Actor[] {
  const { exact, time, duration, runners, parameters } = picture
  const { from, to } = layout.extent
  const start = parameters.position!
  const placed = (s: number) => ({
    body: bodyAt(clamp(s, from, to), picture, layout, projection),
    distance: Math.abs(s - start),
    beyond: s < from - 1e-9 ? (-1 as const) : s > to + 1e-9 ? (1 as const) : (0 as const),
  })
  const simulated = runners.map((runner) => {
    const { drawnS } = runner.trajectory
    const goal = (runner.goal ?? runner.trajectory).drawnS
    const row = rowAt(runner.trajectory, time)
    const end = endOf(runner.trajectory)
    return {
      ...placed(drawnS[row]!),
      distance: Math.abs(goal[row]! - start),
      last: clamp(goal[goal.length - 1]!, from, to),
      end: end && row >= end.row ? end : undefined,
      restsAt: end?.kind === 'at-rest' ? end.time : undefined,
      row,
      runner,
    }
  })
  const { last } = exactExtent(exact, duration)
  return [...simulated, { ...placed(exact(time, { s: 0, v: 0 }).s), last }]
}

/** A block, or a ball, at a place of the track. */
export function bodyAt(
  s: number,
  { scene }: Picture,
  { block }: Layout,
  projection: Projection,
): DrawnBody {
  return { spot: projection.at(s), size: block, round: viewOf(scene).falls }
}
