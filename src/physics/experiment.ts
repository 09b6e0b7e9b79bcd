import type { frameClocks } from './frames/index.ts'
import type { IntegratorId } from './integrators/index.ts'
import type { Measuring } from './measured.ts'
import type { Chosen, ChosenWhole } from './options.ts'
import type { SceneId, scenes } from './scenes/index.ts'
import type { StoppingId } from './stopping/index.ts'
import type { timesteps } from './timesteps/index.ts'

type KeysOfEach<T> = T extends unknown ? keyof T : never

/** The name of a parameter of some scene. */
export type ParameterName = KeysOfEach<(typeof scenes)[number]['parameters']>

/** How physics time follows from frame time: a policy's id as `kind`, and its options. */
export type Timestep = Chosen<(typeof timesteps)[number]>

/** How frames follow each other: a clock's id as `kind`, and its options; and how the game measures them. */
export type FramesChoice = Chosen<(typeof frameClocks)[number]> & Measuring

/**
 * Everything that determines a run, as plain JSON: the same object in addresses, attributes, messages and tests.
 * SI units; angles in degrees. Properties that are left out have their defaults.
 */
export interface Experiment {
  scene: SceneId
  /** The scene's parameters, each in the range that the scene gives, and consistent with each other. */
  parameters?: Readonly<Partial<Record<ParameterName, number>>>
  /** Default: velocity Verlet. */
  integrator?: IntegratorId
  /** Default: located. */
  stopping?: StoppingId
  /** Default: variable. */
  timestep?: Timestep
  /** Default: steady, 60 fps. */
  frames?: FramesChoice
  /** How long the run lasts [s]; the last frame is cut to end here. Default: the scene's. */
  duration?: number
  /** How fast the game's time goes: at 0.1 a second on the wall moves the block by a tenth of a second. Default: 1. */
  timeScale?: number
}

/** An experiment with every default filled in. */
export interface ResolvedExperiment {
  scene: SceneId
  parameters: Readonly<Record<string, number>>
  integrator: IntegratorId
  stopping: StoppingId
  timestep: ChosenWhole<(typeof timesteps)[number]>
  /** How the game measures them is left out where it is exact. */
  frames: ChosenWhole<(typeof frameClocks)[number]> & Measuring
  duration: number
  timeScale: number
}

/** The defaults of an experiment. */
export const defaults = {
  integrator: 'velocity-verlet',
  stopping: 'located',
  timestep: { kind: 'variable' },
  frames: { kind: 'steady', fps: 60 },
  timeScale: 1,
} as const

/** Upper bounds for a run. */
export const limits = {
  /** [s] */
  duration: 1e6,
  timeScale: { min: 0.01, max: 100 },
  frames: 1e6,
  steps: 5e6,
  /** Evaluations of the acceleration, including those that locate events: a few seconds of work. */
  evaluations: 1e8,
  /**
   * Bounds for a run to a tolerance, whose work can't be forecast: about a second, twice that for methods of second order
   * or more, plus an allowance a frame. A method of first order has no chance where this is too little.
   */
  toTolerance: { evaluationsAnOrder: 5e6, evaluationsAFrame: 100 },
} as const
