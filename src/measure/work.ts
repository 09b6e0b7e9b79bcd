import { createRun, simulate } from '../physics/index.ts'
import type { Experiment, Trajectory } from '../physics/index.ts'

/** The time on some clock [ms]: `performance.now`, or a clock of a test. */
export type Clock = () => number

/** So long a measurement of time lasts at least [ms]: ten ticks of a clock that goes in tenths of milliseconds. */
const LONG_ENOUGH = 1

/** So many runs are made ready at a time, before the clock is looked at. */
const MOST_AT_ONCE = 256

/** So many times that, and no more, however short the runs. */
const MOST_BATCHES = 64

/** Evaluations of the acceleration for each simulated second. NaN for a run of no length. */
export function evaluationsPerSecond({ evaluations, time }: Trajectory): number {
  return evaluations / time[time.length - 1]!
}

/**
 * Time that one simulated second takes [ns], frame by frame as a game takes it: many runs of the experiment, made ready
 * before the clock is looked at. One measurement; the least of several is what the work takes without disturbance.
 *
 * @param clock what tells the time; it may tick coarsely
 * @throws ExperimentError for an experiment that can't be run
 */
export function nanosecondsPerSecond(experiment: Experiment, clock: Clock): number {
  const { time } = simulate(experiment)
  const frames = time.subarray(1).map((now, row) => now - time[row]!)
  let count = 1
  let runs = 0
  let elapsed = 0
  for (let batch = 0; batch < MOST_BATCHES && elapsed < LONG_ENOUGH; batch++) {
    const ready = Array.from({ length: count }, () => createRun(experiment))
    const start = clock()
    for (const run of ready) for (let i = 0; i < frames.length; i++) run.frame(frames[i]!)
    elapsed += clock() - start
    runs += count
    count = Math.min(2 * count, MOST_AT_ONCE)
  }
  return (elapsed * 1e6) / (runs * time[time.length - 1]!)
}
