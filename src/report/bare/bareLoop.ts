import type { Experiment, IntegratorId, SceneId } from '../../physics/index.ts'

/** How a bare loop ends. */
export interface End {
  /** Distance along the track [m] and speed [m/s]. */
  s: number
  v: number
  /** What friction has turned into heat [J]. */
  heat: number
}

/** All of a scene's parameters, the starting position and speed among them. */
export type Given = Readonly<Record<string, number>>

/** A motion that a bare loop and the project's own steps are both timed on: that many steps of 1/fps seconds. */
export interface Trial {
  readonly scene: SceneId
  /** The block moves all the time, or it comes to rest on its way. */
  readonly kind: 'moves' | 'stops'
  readonly parameters: Given
  readonly fps: number
  /** A whole number of seconds' worth. */
  readonly steps: number
}

/** Takes that many steps of `dt` seconds from the parameters' `position` and `speed`. */
export type Loop = (given: Given, dt: number, steps: number) => End

/** What somebody would write by hand for one scene and one method, with located stops, and nothing else. */
export interface BareLoop {
  readonly scene: SceneId
  readonly integrator: IntegratorId
  readonly trials: readonly Trial[]
  readonly end: Loop
  /** The same, its result made into one number, so that no engine can leave the work out. */
  run(given: Given, dt: number, steps: number): number
}

/**
 * A trial as an experiment that takes its steps a second at a time: what a step costs by itself is measured on this,
 * by `run.frame(1)`, once for each second.
 */
export function inSeconds({ scene, parameters, fps, steps }: Trial, integrator: IntegratorId) {
  return {
    scene,
    parameters,
    integrator,
    timestep: { kind: 'substeps', step: 1 / fps },
    frames: { kind: 'steady', fps: 1 },
    duration: steps / fps,
  } as const satisfies Experiment
}

/** A trial as an experiment with a step a frame: what `simulate` costs with all that it records is measured on this. */
export function inFrames({ scene, parameters, fps, steps }: Trial, integrator: IntegratorId) {
  return {
    scene,
    parameters,
    integrator,
    frames: { kind: 'steady', fps },
    duration: steps / fps,
  } as const satisfies Experiment
}
