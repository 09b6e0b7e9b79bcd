import type { Experiment } from './experiment.ts'
import { FrameLoop } from './frameLoop.ts'
import type { FrameClock } from './frameClock.ts'
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
  const clock: FrameClock = entry(frameClocks, resolved.frames.kind)
  const expected = clock.frames(resolved.frames as never, resolved.duration)
  // Rounding does not make a frame more of a whole number of them.
  const recorder = new Recorder(Math.ceil(expected * (1 - 1e-9)) + 1)
  const loop = new FrameLoop(resolved)
  recorder.record(loop.run)
  while (loop.goesOn) {
    loop.row(recorder)
    loop.next()
    recorder.record(loop.run)
  }
  return recorder.trajectory(resolved, loop.run)
}
