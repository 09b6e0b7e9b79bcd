import { addHeat } from './heat.ts'
import { FAR } from './law.ts'
import type { Motion } from './motion.ts'

/** Ends a step that a stopping rule accepts: adds the heat that friction made in it, and notices what no real motion comes to. */
export function settle(motion: Motion): void {
  if (Math.abs(motion.v) <= motion.law.speedLimit && Math.abs(motion.s) <= FAR) {
    addHeat(motion)
    return
  }
  motion.end('diverged')
  // What a trajectory holds is always a number that can be drawn.
  if (!(Math.abs(motion.s) + Math.abs(motion.v) < Infinity)) motion.rewind()
}
