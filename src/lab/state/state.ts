import type { Parameters, ResolvedExperiment, SceneId } from '../../physics/index.ts'
import type { Method } from '../../measure/index.ts'

/** How one block is moved: everything of an experiment that the runners of a lab do not share, and its looks. */
export interface RunnerState extends Method {
  readonly frames: ResolvedExperiment['frames']
  /** Its place in the palette of runner colours and marks, 0 … 7. It keeps it when others come and go. */
  readonly paletteIndex: number
  readonly hidden: boolean
  /** The name of the engine that moves its block so by default; nothing once the method is changed. */
  readonly engine?: string | undefined
}

/** All that a lab shows, as a plain value: every number and every pixel follows from it. */
export interface LabState {
  readonly scene: SceneId
  /** All of the scene's parameters. */
  readonly parameters: Parameters
  /** How long each run lasts [s]. */
  readonly duration: number
  /** How fast the game's time goes: 0.1 is slow motion. */
  readonly timeScale: number
  readonly runners: readonly RunnerState[]
}
