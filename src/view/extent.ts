import type { ExactMotion, Trajectory } from '../physics/index.ts'
import { clamp } from '../chart/geometry.ts'
import type { Picture } from './picture.ts'
import { samplesOf } from './samples.ts'
import { viewOf } from './scenes.ts'

/** A stretch of the track [m]. */
export interface Extent {
  readonly from: number
  readonly to: number
}

/**
 * The stretch of track that a picture must show: the start, the true motion, and the runners as far as they stay
 * within reach of it. One that diverges would shrink everything else to a point.
 */
export function extentOf(picture: Picture): Extent {
  const truth = exactExtent(picture.exact, picture.duration)
  const start = picture.parameters.position!
  let from = Math.min(truth.from, start)
  let to = Math.max(truth.to, start)
  const least = viewOf(picture.scene).least(picture.parameters)
  const reach = Math.max(to - from, least)
  const low = from - reach
  const high = to + reach
  for (const { trajectory } of picture.runners) {
    const run = runExtent(trajectory)
    from = Math.min(from, clamp(run.from, low, high))
    to = Math.max(to, clamp(run.to, low, high))
  }
  return widened({ from, to }, least)
}

function widened({ from, to }: Extent, least: number): Extent {
  const lack = Math.max(0, least - (to - from)) / 2
  return { from: from - lack, to: to + lack }
}

const runs = new WeakMap<Trajectory, Extent>()

function runExtent(trajectory: Trajectory): Extent {
  let extent = runs.get(trajectory)
  if (!extent) runs.set(trajectory, (extent = rangeOf(trajectory.drawnS)))
  return extent
}

/** The range of the true motion in a duration, and where it is at its end [m]. */
interface Truth extends Extent {
  readonly last: number
}

const truths = new WeakMap<Float64Array, Truth>()

export function exactExtent(exact: ExactMotion, duration: number): Truth {
  const { s } = samplesOf(exact, duration)
  let truth = truths.get(s)
  if (!truth) truths.set(s, (truth = { ...rangeOf(s), last: s.at(-1)! }))
  return truth
}

function rangeOf(values: Float64Array): Extent {
  let from = Infinity
  let to = -Infinity
  for (const s of values) {
    if (s < from) from = s
    if (s > to) to = s
  }
  return { from, to }
}
