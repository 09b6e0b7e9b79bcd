import { createRun, simulate } from '../physics/index.ts'
import type { Experiment, Trajectory } from '../physics/index.ts'

/** Returns the time [ms]: `performance.now`, or a test's clock. */
export type Clock = () => number

/** The least length of a measurement in clock ticks: this makes it accurate to 2 %. */
const TICKS = 50

/** The least length of a measurement [ms], however fine the clock: interruptions dominate a shorter one. */
const LONG_ENOUGH = 1

/** So many ticks are looked at to find the length of one, in so many readings at most. */
const TICKS_SEEN = 5
const MOST_READINGS = 2_000_000

/** The most runs that are prepared at a time, before the clock is read. */
const MOST_AT_ONCE = 256

/** The most batches of runs, however short the runs. */
const MOST_BATCHES = 1024

/** Evaluations of the acceleration for each simulated second. NaN for a run of no length. */
export function evaluationsPerSecond({ evaluations, time }: Trajectory): number {
  return evaluations / time[time.length - 1]!
}

/** The tick of a clock [ms]: the shortest step seen in a few. Infinity for a clock that does not advance. */
export function tickOf(clock: Clock): number {
  let tick = Infinity
  let last = clock()
  let seen = 0
  for (let reading = 0; reading < MOST_READINGS && seen < TICKS_SEEN; reading++) {
    const now = clock()
    if (now === last) continue
    tick = Math.min(tick, now - last)
    last = now
    seen++
  }
  return tick
}

/**
 * Time that one simulated second takes [ns], frame by frame as a game takes it: many runs of the experiment, prepared
 * before the clock is read. This is one measurement; the least of several is the least disturbed.
 *
 * @param clock what tells the time
 * @param tick of the clock [ms], from `tickOf`
 * @returns NaN if the work ends before the clock has ticked often enough
 * @throws ExperimentError for an experiment that can't be run
 */
export function nanosecondsPerSecond(experiment: Experiment, clock: Clock, tick: number): number {
  // The last of the fifty may be short by a rounding error.
  const wanted = Math.max(LONG_ENOUGH, (TICKS - 0.5) * tick)
  const { time } = simulate(experiment)
  const frames = time.subarray(1).map((now, row) => now - time[row]!)
  let count = 1
  let runs = 0
  let elapsed = 0
  for (let batch = 0; batch < MOST_BATCHES && elapsed < wanted; batch++) {
    const ready = Array.from({ length: count }, () => createRun(experiment))
    const start = clock()
    for (const run of ready) for (let i = 0; i < frames.length; i++) run.frame(frames[i]!)
    elapsed += clock() - start
    runs += count
    count = Math.min(2 * count, MOST_AT_ONCE)
  }
  if (elapsed < wanted) return NaN
  return (elapsed * 1e6) / (runs * time[time.length - 1]!)
}
