import { exactOf } from './exact/motion.ts'
import { lawOf } from './law.ts'
import type { Law } from './law.ts'
import type { Described, NumberOption } from './options.ts'
import { placeOn } from './track.ts'
import type { ExactMotion, Parameters, Place } from './state.ts'
import type { Track } from './track.ts'

/** The definition of a scene: its track, its parameters and how it is shown. The rest follows from the track. */
export interface SceneData extends Described {
  readonly parameters: Readonly<Record<string, NumberOption>>
  /** How long a run lasts unless it says otherwise [s]. */
  readonly duration: number
  /** The direction of growing s in pictures: 1 to the right, −1 to the left. */
  readonly facing: 1 | -1
  /** The problem with parameters that are each in range but don't go together; undefined if there is none. */
  conflict?(parameters: Parameters): { parameter: string; problem: string } | undefined
  track(parameters: Parameters): Track
}

/** A scene with what follows from its track. */
export interface Scene extends SceneData {
  /** The constants of the law that a step integrates. */
  law(parameters: Parameters): Law
  /** The point of the track at a distance s. */
  place(parameters: Parameters, s: number): Place
  /** Potential energy per mass at s, gravity's and the spring's [J/kg]. */
  potential(parameters: Parameters, s: number): number
  /** The true motion, in closed form or as a series exact to rounding. */
  exact(parameters: Parameters): ExactMotion
}

/** Derives the rest of a scene. A force without a parameter in the scene does not act. */
export function defineScene<const T extends SceneData>(data: T): T & Scene {
  // Cached: a picture needs hundreds of points of the same track.
  const tracks = new WeakMap<Parameters, Track>()
  const track = (parameters: Parameters): Track => {
    const known = tracks.get(parameters) ?? data.track(parameters)
    tracks.set(parameters, known)
    return known
  }
  return {
    ...data,
    track,
    law: (parameters) => lawOf(track(parameters), parameters),
    place: (parameters, s) => placeOn(track(parameters), s),
    potential: (parameters, s) => {
      const { gravity = 0, stiffness = 0, mass = 1 } = parameters
      return gravity * placeOn(track(parameters), s).y + 0.5 * (stiffness / mass) * s * s
    },
    exact: (parameters) => exactOf(track(parameters), parameters),
  }
}
