import { exactMotion, scenes } from '../physics/index.ts'
import type { ResolvedExperiment, Scene } from '../physics/index.ts'

/** The scales of a run, against which rounding is judged. */
export interface Scale {
  /** The length of the true path, |s| at its largest, and a metre at least [m]. */
  readonly length: number
  /** The largest kinetic energy plus potential energy, in size [J]. */
  readonly energy: number
}

// The exact motion promises 1e-11 of |s|, and 1e-11 m within the first metre: no smaller error can be told from its own.
const PART = 1e-11

/** A difference, or 0 if it is rounding: smaller than 1e-11 of the scale. */
export function withoutRounding(difference: number, scale: number): number {
  return Math.abs(difference) < PART * scale ? 0 : difference
}

/** The smallest difference that is more than rounding. */
export function leastDifference(scale: number): number {
  return PART * scale
}

const SAMPLES = 64
const known = new WeakMap<object, Scale>()

/**
 * The scale of an experiment, from the true motion, so that a run that goes astray does not enlarge its own tolerance.
 */
export function scaleOf(experiment: ResolvedExperiment): Scale {
  let scale = known.get(experiment)
  if (!scale) known.set(experiment, (scale = find(experiment)))
  return scale
}

function find(experiment: ResolvedExperiment): Scale {
  const { parameters, duration, timeScale } = experiment
  const scene: Scene = scenes.find(({ id }) => id === experiment.scene)!
  const motion = exactMotion(experiment)
  const truth = { s: 0, v: 0 }
  let length = 1
  let energy = 0
  for (let i = 0; i <= SAMPLES; i++) {
    const { s, v } = motion((timeScale * duration * i) / SAMPLES, truth)
    // If the true motion is not known, both are NaN, and every comparison is false.
    if (Math.abs(s) > length) length = Math.abs(s)
    const sum = parameters.mass! * (0.5 * v * v + Math.abs(scene.potential(parameters, s)))
    if (sum > energy) energy = sum
  }
  return { length, energy }
}
