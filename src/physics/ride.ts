import type { Motion } from './motion.ts'
import type { StoppingRule } from './stoppingRule.ts'

// Where static friction gives way, in parts of the forces that tie there: just beyond what `holds` takes for rounding.
const BEYOND_TIE = 16 * Number.EPSILON

/**
 * Moves a block that a belt carries on by `motion.dt`, or by less, which it then leaves there: up to where the spring
 * overcomes static friction, if the rule finds such places. While it rides, the block does not slide: no friction heats it.
 */
export function ride(motion: Motion, rule: StoppingRule): void {
  const { s, law, tangential, weight } = motion
  const { belt, stiffness, mass } = law
  const most = law.muStatic * weight
  const direction = belt > 0 ? 1 : -1
  const release =
    (tangential + direction * (most + BEYOND_TIE * (2 * most + Math.abs(tangential)))) / stiffness
  const time = (release - s) / belt
  if (rule.keepsOrder && time < motion.dt) {
    motion.dt = time
    motion.s = release
  } else motion.s = s + belt * motion.dt
  // Friction balances the spring and gravity: what they take, the belt gives.
  const middle = 0.5 * (s + motion.s)
  motion.work += mass * (stiffness * middle - tangential) * (motion.s - s)
}
