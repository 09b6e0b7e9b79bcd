import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'
import { enterPiece } from '../piece.ts'
import { settle } from '../settle.ts'
import type { StoppingRule } from '../stoppingRule.ts'
import { locate } from './locate.ts'
import { setsOff } from './staticFriction.ts'

// Stops and joints inside one step. A real motion has a handful; a run that asks for more has lost its way.
const MOST_EVENTS = 100

/** Steps exactly up to the instant at which the law jumps, decides there, and goes on with the rest of the step. */
export const located = {
  id: 'located',
  label: 'Located',
  about:
    'Finds the instant inside the step at which the block stops or meets a joint, and goes on from there: no trace of the frame rate is left.',
  keepsOrder: true,
  holdsSlip: true,
  // #region advance
  advance(motion: Motion, integrator: Integrator): void {
    const whole = motion.dt
    motion.elapsed = 0
    for (let events = 0; motion.elapsed < whole && motion.moving; events++) {
      if (events === MOST_EVENTS) motion.end('diverged')
      else if (motion.v !== 0 || setsOff(motion)) {
        motion.dt = whole - motion.elapsed
        advanceToJump(motion, integrator)
      }
    }
    motion.dt = whole
  },
  // #endregion
} as const satisfies StoppingRule

/** Moves on by `motion.dt`, or only to the first jump of the law. */
function advanceToJump(motion: Motion, integrator: Integrator): void {
  const { slip } = motion
  // A step that ended at a joint to the bit left the block on the piece behind it.
  if ((slip > 0 ? motion.s >= motion.to : motion.s <= motion.from) && !enterPiece(motion)) {
    motion.end('left-the-track')
    return
  }
  motion.begin()
  integrator.step(motion)
  let turned = motion.law.turnMatters && (slip > 0 ? motion.v < 0 : motion.v > 0)
  if (turned) locate(motion, integrator, 'turn')
  const joint = motion.s > motion.to ? 'to' : motion.s < motion.from ? 'from' : undefined
  if (joint) {
    turned = false
    locate(motion, integrator, joint)
    motion.s = motion[joint]
  }
  if (turned) {
    motion.v = 0
    motion.known = 0
  }
  motion.elapsed += motion.dt
  settle(motion)
  if (joint && motion.moving) {
    motion.slip = joint === 'to' ? 1 : -1
    if (!enterPiece(motion)) motion.end('left-the-track')
  }
}
