import type { Motion } from './motion.ts'
import type { StoppingRule } from './stoppingRule.ts'

// Static friction gives way at this relative excess over a tie: just beyond what `holds` counts as rounding.
const BEYOND_TIE = 16 * Number.EPSILON

/**
 * Moves a block that rides on a belt by `motion.dt`, or by a shorter time that it leaves there: up to where the spring
 * overcomes static friction, if the rule locates events. A riding block does not slide, so friction makes no heat.
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
  // Friction balances the spring and gravity, so the belt does the work that they take.
  const middle = 0.5 * (s + motion.s)
  motion.work += mass * (stiffness * middle - tangential) * (motion.s - s)
}
