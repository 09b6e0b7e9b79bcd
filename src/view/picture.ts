import type { ExactMotion, Parameters, Scene, Trajectory } from '../physics/index.ts'
import type { Point } from '../chart/geometry.ts'

/** One simulated block in a picture. */
export interface PictureRunner {
  readonly trajectory: Trajectory
  /** The run that its numbers tell of, where that is not the one drawn: while it glides from one to the other. */
  readonly goal?: Trajectory | undefined
  /** As its label says it: “10 fps”. */
  readonly name: string
  /** Its place in the palette of runner colours and in the list of marks, 0 … 7. */
  readonly paletteIndex: number
}

/** What an arrow on a block stands for. */
export type ArrowId = 'gravity' | 'normal' | 'friction' | 'other' | 'sum' | 'velocity'

/** An arrow on a block, in the world's frame: x in the scene's own direction, y upwards. */
export interface PictureVector {
  readonly id: ArrowId
  /** The letters at its tip: “N”. */
  readonly tag: string
  /** [N], of a velocity [m/s]. */
  readonly x: number
  readonly y: number
}

/** The forces on a block and its velocity, and what they are drawn to scale with. */
export interface PictureForces {
  readonly vectors: readonly PictureVector[]
  /** Unit vectors along the track and out of it. */
  readonly along: Point
  readonly across: Point
  /** The largest force [N] and speed [m/s] of the whole run: the longest arrows. */
  readonly largest: number
  readonly fastest: number
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
  /** The exact block is not to be seen. */
  readonly withoutExact?: boolean | undefined
  /** Which of the runners is looked at closely: its physics is shown where that is not where it is drawn. */
  readonly selected?: number | undefined
  /** The forces on that runner's block; undefined where none are to be shown. */
  readonly forces?: PictureForces | undefined
  /** Which of the scene's handles it has: all unless it says otherwise. */
  readonly handles?: readonly HandleId[] | undefined
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
