import type { ExactMotion, Parameters, Scene, Trajectory } from '../physics/index.ts'

/** One simulated block in a picture. */
export interface PictureRunner {
  readonly trajectory: Trajectory
  /** As its label says it: “10 fps”. */
  readonly name: string
  /** Its place in the palette of runner colours and in the list of marks, 0 … 7. */
  readonly look: number
}

/** All that the stage shows, as a value: equal pictures on equal canvases give equal pixels. */
export interface Picture {
  readonly scene: Scene
  /** All of the scene's parameters. */
  readonly parameters: Parameters
  /** How long the run lasts [s]. */
  readonly duration: number
  /** The instant shown, on the wall clock [s]. */
  readonly time: number
  /** Those that are visible. */
  readonly runners: readonly PictureRunner[]
  /** The true motion. */
  readonly exact: ExactMotion
  /** The handle that is held, if one is, and the one that is pointed at or focused. */
  readonly held?: HandleId | undefined
  readonly lit?: HandleId | undefined
}

/** What can be taken hold of: the track's end (tilts it), the block at its start (places it), its arrow (pushes it). */
export type HandleId = 'tilt' | 'place' | 'push'

/** A handle as it stands in the picture, in CSS pixels from the canvas's top left corner. */
export interface Handle {
  readonly id: HandleId
  readonly x: number
  readonly y: number
  /** The parameter that it changes. */
  readonly parameter: string
}
