import type { Experiment } from './experiment.ts'
import { entry } from './lists.ts'
import { Motion } from './motion.ts'
import { parseExperiment } from './parse.ts'
import type { Scene } from './scene.ts'
import type { State } from './state.ts'
import { scenes } from './scenes/index.ts'
import { stoppings } from './stopping/index.ts'
import { sinCos } from './trigonometry.ts'
import { dot, plus, times } from './vector.ts'
import type { Vector } from './vector.ts'

/** The forces on a block [N], and the directions they are made of. */
export interface ForceVectors {
  /** Unit vector along the track, in the direction of growing s. */
  along: Vector
  /** Unit vector out of the track, n̂. */
  across: Vector
  /** G = m g. */
  gravity: Vector
  /** The normal force, N = m press n̂; on a straight slope −m (g·n̂) n̂. */
  normal: Vector
  /** Sliding: −μk |N| v̂. At rest: whatever balances the drive, up to μs |N|. */
  friction: Vector
  /** The scene's own force along the track: the spring's, or air drag. */
  other: Vector
  sum: Vector
  /** The sum divided by the mass [m/s²]. */
  acceleration: Vector
  /** Whether friction holds the block, brakes it, or is absent: from the scene, or by the stopping rule. */
  frictionKind: 'held' | 'sliding' | 'none'
}

/**
 * The paper's vectors, corrected, for a block of an experiment at a state. Along the track their sum is the mass
 * times the acceleration that a step integrates, across it the centripetal force m v² × curvature.
 *
 * @throws ExperimentError for an experiment that can't be run
 */
export function forcesAt(experiment: Experiment, { s, v }: State): ForceVectors {
  const { scene: id, parameters, stopping } = parseExperiment(experiment)
  const scene: Scene = entry(scenes, id)
  const law = scene.law(parameters)
  const { slope } = scene.place(parameters, s)
  const direction = sinCos(slope)
  const along = { x: direction.cos, y: -direction.sin }
  const across = { x: direction.sin, y: direction.cos }
  const motion = new Motion(law, s, v, true)
  // Without a slip direction the acceleration contains no friction.
  motion.slide(0)
  const drive = motion.acceleration(s, v)
  // A track can't pull: a block that is too fast for a crest has left it.
  const press = Math.max(0, motion.weight + motion.curvature * (v * v))
  // A rule that only knows the slip direction applies no friction to a block that does not slide.
  const atRest = v === law.belt && entry(stoppings, stopping).holdsSlip
  const held = atRest && law.muStatic > 0 && !motion.setsOff()
  const slip = atRest ? motion.slip : Math.sign(v - law.belt)
  // #region vectors
  const gravity = { x: 0, y: -law.mass * parameters.gravity! }
  const normal = times(law.mass * press, across)
  const friction = times(-law.mass * (held ? drive : slip * law.muKinetic * press), along)
  const other = times(law.mass * drive - dot(gravity, along), along)
  const sum = plus(gravity, normal, friction, other)
  // #endregion
  return {
    along,
    across,
    gravity,
    normal,
    friction,
    other,
    sum,
    acceleration: times(1 / law.mass, sum),
    frictionKind: held ? 'held' : law.muStatic > 0 && slip !== 0 ? 'sliding' : 'none',
  }
}
