import { addHeat } from './heat.ts'
import type { Integrator } from './integrator.ts'
import { FAR } from './law.ts'
import type { Motion } from './motion.ts'
import type { StoppingRule } from './stoppingRule.ts'

// Of one step, between stops, joints and shortened steps. A real motion has a handful, an oscillation that is far too fast
// for the step some hundreds; a run that needs more has lost its way.
const MOST_PARTS = 10_000

/**
 * Moves on by `motion.dt` seconds: in one step of the integrator or, where the stopping rule ends a step early, in several.
 * Nothing else moves a block.
 */
// #region advance
export function advance(motion: Motion, integrator: Integrator, rule: StoppingRule): void {
  const whole = motion.dt
  motion.elapsed = 0
  for (let parts = 0; motion.elapsed < whole && motion.moving; parts++) {
    if (parts === MOST_PARTS) motion.end('diverged')
    else if (motion.v !== 0 || !rule.holdsSlip || motion.setsOff()) {
      const left = whole - motion.elapsed
      motion.dt = left
      motion.begin()
      rule.step(motion, integrator)
      motion.elapsed = motion.dt === left ? whole : motion.elapsed + motion.dt
      if (motion.moving) accept(motion)
    }
  }
  motion.dt = whole
}
// #endregion

/** Accepts the step from the beginning noted to the present state, and moves on to the next piece of track. */
function accept(motion: Motion): void {
  const { s, v } = motion
  if (!(Math.abs(v) <= motion.law.speedLimit && Math.abs(s) <= FAR)) {
    motion.end('diverged')
    // A trajectory holds nothing but finite numbers.
    if (!(Math.abs(s) + Math.abs(v) < Infinity)) motion.rewind()
    return
  }
  addHeat(motion)
  if (v !== 0) motion.slip = v > 0 ? 1 : -1
  if ((s >= motion.to || s <= motion.from) && !motion.enterPiece()) motion.end('left-the-track')
}
