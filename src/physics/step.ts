import { addHeat } from './heat.ts'
import type { Integrator } from './integrator.ts'
import { FAR } from './law.ts'
import type { Motion } from './motion.ts'
import { ride } from './ride.ts'
import type { StoppingRule } from './stoppingRule.ts'

// The most parts of one step, which end at stops, joints and cuts. A real motion has a handful, an oscillation far too fast
// for the step some hundreds; a run that needs more has diverged.
const MOST_PARTS = 10_000

/**
 * Advances by `motion.dt` seconds: in one step of the integrator or, if the stopping rule ends a step early, in several.
 * Only this function moves a block.
 *
 * @param once takes the first of these steps only, and leaves its length in `motion.dt`
 */
// #region advance
export function advance(
  motion: Motion,
  integrator: Integrator,
  rule: StoppingRule,
  once = false,
): void {
  const whole = motion.dt
  let left = whole
  motion.elapsed = 0
  for (let parts = 0; left > 0 && motion.moving; parts++) {
    if (parts === MOST_PARTS) return motion.end('diverged')
    if (motion.v === motion.law.belt && rule.holdsSlip && !motion.setsOff()) {
      if (!motion.moving) break
      ride(motion, rule)
    } else {
      motion.begin()
      rule.step(motion, integrator)
      if (motion.outcome !== 'diverged') accept(motion)
    }
    motion.elapsed = motion.dt === left ? whole : motion.elapsed + motion.dt
    if (once) return
    left = whole - motion.elapsed
    motion.dt = left
  }
  motion.dt = whole
}
// #endregion

/** Accepts the step from its recorded start to the present state; at a joint, enters the next piece of track. */
function accept(motion: Motion): void {
  const { s, v, slip } = motion
  const isOnPiece = s > motion.from && s < motion.to && Math.abs(v) <= motion.law.speedLimit
  if (!isOnPiece && isLost(motion)) return
  addHeat(motion)
  const relative = v - motion.law.belt
  if (slip > 0 ? relative < 0 : relative > 0) motion.slide(relative > 0 ? 1 : -1)
  if (!isOnPiece && !motion.enterPiece()) motion.end('left-the-track')
  if (motion.isLifted()) motion.end('left-the-track')
}

/** Ends a motion that is farther or faster than any real one; returns whether it was. */
function isLost(motion: Motion): boolean {
  const { s, v } = motion
  if (Math.abs(s) < FAR && Math.abs(v) <= motion.law.speedLimit) return false
  motion.end('diverged')
  // A trajectory contains only finite numbers.
  if (!(Math.abs(s) + Math.abs(v) < Infinity)) motion.rewind()
  return true
}
