import type { Experiment } from './experiment.ts'
import type { FrameClock, Frames } from './frameClock.ts'
import { frameClocks } from './frames/index.ts'
import { entry } from './lists.ts'
import { parseExperiment } from './parse.ts'
import { Run } from './run.ts'
import { Recorder } from './trajectory.ts'
import type { Trajectory } from './trajectory.ts'

/**
 * A run of an experiment that the caller drives, one `frame(dt)` at a time, as a game loop does. The experiment's
 * `frames` and `duration` say nothing here: the caller's frames do.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function createRun(experiment: Experiment): Run {
  return new Run(parseExperiment(experiment))
}

/**
 * Runs an experiment from beginning to end. Equal experiments give equal bits, on every engine.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function simulate(experiment: Experiment): Trajectory {
  const resolved = parseExperiment(experiment)
  const { duration } = resolved
  const clock: FrameClock = entry(frameClocks, resolved.frames.kind)
  const frames = clock.start(resolved.frames as never)
  const run = new Run(resolved)
  const recorder = new Recorder(
    Math.ceil(1.02 * duration * clock.rate(resolved.frames as never)) + 2,
  )
  recorder.record(run)
  while (run.time < duration && !run.ended) {
    nextFrame(run, frames, duration)
    recorder.record(run)
  }
  return recorder.trajectory(resolved, run)
}

/** Runs one frame more, which is cut where the run ends. */
function nextFrame(run: Run, frames: Frames, duration: number): void {
  frames.next()
  // A frame that would leave only rounding behind it is the last.
  const slack = 1e-9 * frames.duration
  const over = frames.time - duration
  run.frameDuration = over > slack ? duration - run.time : frames.duration
  run.time = over >= -slack ? duration : frames.time
  run.advanceFrame()
}
