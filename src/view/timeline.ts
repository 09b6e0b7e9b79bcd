import type { Trajectory } from '../physics/index.ts'

/** The latest row of a trajectory at a time: the last frame that has been shown by then. */
export function rowAt(trajectory: Trajectory, time: number): number {
  const { time: times } = trajectory
  // A cursor that was set to a frame's time and went through a text field is still on that frame.
  const limit = time + 1e-9
  let low = 0
  let high = times.length - 1
  while (low < high) {
    const middle = (low + high + 1) >> 1
    if (times[middle]! <= limit) low = middle
    else high = middle - 1
  }
  return low
}

/** When a run stopped, flew off or diverged: the first row that shows it, and the wall clock's time [s]. */
export interface End {
  readonly kind: 'at-rest' | 'left-the-track' | 'diverged'
  readonly row: number
  readonly time: number
}

const ends = new WeakMap<Trajectory, { end: End | undefined }>()

/** How a run ended, if it did. Its outcome tells the time of the physics clock, which need not be that of the wall. */
export function endOf(trajectory: Trajectory): End | undefined {
  let known = ends.get(trajectory)
  if (!known) ends.set(trajectory, (known = { end: findEnd(trajectory) }))
  return known.end
}

function findEnd({ outcome, stateTime, time }: Trajectory): End | undefined {
  const { kind } = outcome
  if (kind === 'moving') return undefined
  const found = stateTime.findIndex((t) => t >= outcome.time - 1e-12)
  const row = found < 0 ? time.length - 1 : found
  if (row === 0) return { kind, row, time: time[0]! }
  const from = stateTime[row - 1]!
  const part = (outcome.time - from) / (stateTime[row]! - from)
  const into = part > 0 && part < 1 ? part : 1
  return { kind, row, time: time[row - 1]! + into * (time[row]! - time[row - 1]!) }
}

/** Frames shown in a second, on average. */
export function frameRate({ frames, time }: Trajectory): number {
  const length = time[time.length - 1]!
  return length > 0 ? frames / length : 0
}
