/** The laws of motion. Nothing here depends on a page, the system's clock or unseeded randomness. */

export type {
  Experiment,
  FramesChoice,
  ParameterName,
  ResolvedExperiment,
  Timestep,
} from './experiment.ts'
export { defaults, limits } from './experiment.ts'
export { parseExperiment } from './parse.ts'
export { ExperimentError } from './problems.ts'
export type { Problem } from './problems.ts'

export { createRun } from './createRun.ts'
export type { DrivenRun as Run } from './createRun.ts'
export { simulate } from './simulate.ts'
export type { Outcome } from './run.ts'
export type { Trajectory } from './trajectory.ts'
export { traceFrame } from './trace.ts'
export type { Attempt, Evaluation, PolicyStep, Standing, Stretch, TriedStep } from './trace.ts'
export { triesOf } from './tries.ts'
export type { Tries } from './tries.ts'
export { exact } from './exact/exact.ts'
export { exactMotion } from './exact/index.ts'
export type { Scene } from './scene.ts'
export type { ExactMotion, Parameters, Place, State } from './state.ts'

export { scenes } from './scenes/index.ts'
export type { SceneId } from './scenes/index.ts'
export { integrators } from './integrators/index.ts'
export type { IntegratorId } from './integrators/index.ts'
export type { Integrator } from './integrator.ts'
export { stoppings } from './stopping/index.ts'
export type { StoppingId } from './stopping/index.ts'
export { timesteps } from './timesteps/index.ts'
export type { TimestepId } from './timesteps/index.ts'
export { measuring } from './measured.ts'
export { frameClocks } from './frames/index.ts'
export type { FrameClockId } from './frames/index.ts'
export type {
  ChoiceOption,
  Described,
  ListOption,
  NumberOption,
  Option,
  Options,
  SliderRange,
} from './options.ts'

export { forcesAt } from './forces.ts'
export type { ForceVectors } from './forces.ts'
export { dot, length } from './vector.ts'
export type { Vector } from './vector.ts'
export { allCorrected, asPrinted, corrections, paperStep } from './paper.ts'
export type { PaperBody, Correction, Corrections, Surface } from './paper.ts'
