import { frameClocks, parseExperiment } from '../../physics/index.ts'
import type { Experiment, ResolvedExperiment } from '../../physics/index.ts'
import { checked } from '../state/check.ts'
import type { LabState } from '../state/state.ts'

/** So many frames of all runners together are simulated, and drawn, without a wait that is felt. */
export const MOST_FRAMES = 250_000

/**
 * Experiments as far as they can be shown side by side: those that share scene, parameters and duration are together,
 * in the order in which they come. One that can't be run is alone.
 */
export function together(experiments: readonly Experiment[]): Experiment[][] {
  const groups = new Map<string, Experiment[]>()
  for (const experiment of experiments) {
    const { scene, parameters, duration } = experiment
    const key = JSON.stringify([scene, parameters, duration])
    groups.set(key, [...(groups.get(key) ?? []), experiment])
  }
  return [...groups.values()]
}

/**
 * The lab that runs such experiments, each as a runner. A run that is longer than a page can bear is cut to its
 * beginning.
 *
 * @throws ExperimentError if they can't be run
 */
export function stateOf(experiments: readonly Experiment[]): LabState {
  const resolved = experiments.map(parseExperiment)
  const { scene, parameters } = resolved[0]!
  const runners = resolved.map(({ frames, timestep, integrator, stopping }, look) => ({
    ...{ frames, timestep, integrator, stopping },
    ...{ look, hidden: false },
  }))
  return checked({ scene, parameters, runners, duration: durationOf(experiments) })
}

/** How long they are run there [s]. */
export function durationOf(experiments: readonly Experiment[]): number {
  const resolved = experiments.map(parseExperiment)
  const { duration } = resolved[0]!
  const excess = resolved.reduce((sum, each) => sum + frameCount(each), 0) / MOST_FRAMES
  return excess > 1 ? rounded(duration / excess) : duration
}

function frameCount({ frames, duration }: ResolvedExperiment): number {
  return frameClocks.find(({ id }) => id === frames.kind)!.frames(frames as never, duration)
}

/** Down to two digits. */
function rounded(x: number): number {
  const unit = 10 ** (Math.floor(Math.log10(x)) - 1)
  return Math.floor(x / unit) * unit
}
