import type { Experiment } from './experiment.ts'
import { FrameLoop } from './frameLoop.ts'
import { parseExperiment } from './parse.ts'
import { Recorder } from './trajectory.ts'
import type { Trajectory } from './trajectory.ts'

/**
 * Runs an experiment from beginning to end. Equal experiments give equal bits, on every engine.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function simulate(experiment: Experiment): Trajectory {
  const resolved = parseExperiment(experiment)
  const loop = new FrameLoop(resolved)
  const { run } = loop
  const recorder = new Recorder(loop.expectedFrames + 1)
  recorder.record(run)
  while (loop.next()) recorder.record(run)
  return recorder.trajectory(resolved, run)
}
