import { FAR } from './law.ts'
import type { Motion } from './motion.ts'

/**
 * Finds the piece of track that the block is on, or at a joint the one that it moves into, and takes up its law. Returns
 * false where there is no track.
 */
export function enterPiece(motion: Motion): boolean {
  const { s, slip, law } = motion
  const { joints, open } = law
  let piece = 0
  while (piece < joints.length && (slip < 0 ? s > joints[piece]! : s >= joints[piece]!)) piece++
  motion.from = piece === 0 ? -Infinity : joints[piece - 1]!
  motion.to = piece === joints.length ? Infinity : joints[piece]!
  motion.low = Math.max(motion.from, -FAR)
  motion.high = Math.min(motion.to, FAR)
  takeUpLaw(motion, piece)
  return !open || (piece > 0 && piece < joints.length)
}

/** Works out what is the same all along the piece, with friction to the present side. */
function takeUpLaw(motion: Motion, piece: number): void {
  const { law, slip } = motion
  const { mass, muKinetic } = law
  const given = law.forces[piece]!
  motion.summed = motion.heat
  motion.rubbedFrom = motion.s
  motion.known = 0
  motion.feltS = NaN
  motion.forces = motion.felt[piece]!
  motion.feel()
  motion.pressed = motion.press
  motion.rubs = typeof given === 'function' && muKinetic > 0 ? 1 : 0
  motion.rubbing = muKinetic > 0 ? mass * muKinetic * motion.press : 0
  motion.evenRubbing = 0
  motion.kind = 0
  if (typeof given === 'function' || !motion.slipHeld) return
  const { drive, perMetre = 0, perSquare = 0, press } = given
  motion.friction = slip * muKinetic * press
  motion.perMetre = perMetre
  motion.perSquare = perSquare
  motion.steady = drive
  motion.kind = 2
  if (perMetre > 0 || perSquare > 0) return
  motion.steady = drive - motion.friction
  motion.kind = 1
  motion.evenRubbing = motion.rubbing
  motion.rubbing = 0
}
