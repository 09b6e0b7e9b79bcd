import type { Motion } from './motion.ts'

/** Finds out whether the next steps can be taken in a row, and up to which one it is known that nothing happens. */
export function startRow(motion: Motion): void {
  const { s, v, slip, from, to, law, log, kind } = motion
  motion.taken = motion.free = 0
  // Where the acceleration is constant, heat follows from the distance; and as long as no frame differs, so does nothing else.
  const noted = log !== undefined && (kind !== 1 || log.each === Infinity)
  motion.atEnd = motion.rubs === 1 || noted ? 1 : 0
  motion.keptEvaluations = motion.evaluations
  // Beyond these it has turned, or lost its stability.
  motion.slowest = v > 0 ? 0 : -law.speedLimit
  motion.fastest = v > 0 ? law.speedLimit : 0
  const onPiece = slip > 0 ? s >= from && s < to : s > from && s <= to
  motion.inRow = motion.slipHeld && motion.dt > 0 && v !== 0 && onPiece ? 1 : 0
  if (motion.inRow === 1 && kind === 1 && motion.asked > 1) motion.free = freeSteps(motion)
}

/**
 * How many steps of constant acceleration are sure to reach neither v = 0 nor the end of the piece, whatever their
 * rounding: half as many as would. No run that is allowed gets anywhere near the speed limit by a constant acceleration.
 */
function freeSteps({ s, v, dt, log, asked, steady, low, high }: Motion): number {
  const length = log ? log.each : dt
  const change = Math.abs(steady) * length
  const most = Math.abs(v) + asked * change
  const slows = v > 0 !== steady > 0
  // Where the ulps of s are as large as what is left of the piece, rounding alone could reach its end.
  const room = (v > 0 ? high - s : s - low) - 1e-10 * Math.abs(s)
  const reach = (0.5 * room) / (most * length)
  const turn = slows ? (0.5 * Math.abs(v)) / change : asked
  return Math.min(asked, turn, reach) | 0
}

/** Ends a row at a step that was not kept: takes back what that has counted. */
export function refuse(motion: Motion): void {
  motion.inRow = 0
  if (motion.unsolvedAt === motion.evaluations) motion.unsolved--
  motion.unsolvedAt = -1
  motion.evaluations = motion.keptEvaluations
}
