import { exactMotion, parseExperiment, scenes, simulate } from '../../src/physics/index.ts'
import type { Experiment } from '../../src/physics/index.ts'
import type { Picture } from '../../src/view/picture.ts'

/** The picture of an experiment at the start, a runner for each frame rate. */
export function pictureOf(
  experiment: Experiment,
  rates: readonly number[] = [10, 30, 120],
): Picture {
  const { scene, parameters, duration } = parseExperiment(experiment)
  return {
    scene: scenes.find(({ id }) => id === scene)!,
    parameters,
    duration,
    time: 0,
    runners: rates.map((fps, paletteIndex) => ({
      trajectory: simulate({ ...experiment, frames: { kind: 'steady', fps } }),
      name: `${fps} fps`,
      paletteIndex,
    })),
    exact: exactMotion(experiment),
  }
}
