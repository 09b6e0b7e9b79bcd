import type { Experiment } from './experiment.ts'
import { FrameLoop } from './frameLoop.ts'
import { parseExperiment } from './parse.ts'

/** When a policy that tries steps did so, a value for each try in their order. */
export interface Tries {
  /** When it begins on the physics clock, and how long it is [s]. */
  readonly begins: readonly number[]
  readonly lengths: readonly number[]
  readonly accepted: readonly boolean[]
}

/**
 * The tries of a whole run, which is repeated for it; none under a policy that takes every step that it tries.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function triesOf(experiment: Experiment): Tries {
  const begins: number[] = []
  const lengths: number[] = []
  const accepted: boolean[] = []
  const loop = new FrameLoop(parseExperiment(experiment))
  const { run } = loop
  run.watcher = {
    restored: () => {},
    judged: (isAccepted) => {
      begins.push(run.stateTime)
      // The step taken last is half of it.
      lengths.push(2 * run.motion.dt)
      accepted.push(isAccepted)
    },
  }
  while (loop.next());
  return { begins, lengths, accepted }
}
