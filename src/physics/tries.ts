import type { Experiment } from './experiment.ts'
import { FrameLoop } from './frameLoop.ts'
import { parseExperiment } from './parse.ts'

/** The tries of a policy that chooses its own steps: one value a try, in order. */
export interface Tries {
  /** When each try begins on the physics clock, and its length [s]. */
  readonly begins: readonly number[]
  readonly lengths: readonly number[]
  readonly accepted: readonly boolean[]
}

/**
 * The tries of a whole run, which it simulates again; none under a policy that accepts every step.
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
      lengths.push(run.tried)
      accepted.push(isAccepted)
    },
  }
  while (loop.next());
  return { begins, lengths, accepted }
}
