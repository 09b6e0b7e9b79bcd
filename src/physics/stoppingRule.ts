import type { Integrator } from './integrator.ts'
import type { Described } from './options.ts'
import type { Motion } from './motion.ts'

/** How a step treats jumps of the law: where the block stops or turns, and at the joints of the track. */
export interface StoppingRule extends Described {
  /** Keeps the order of every integrator through stops and joints. */
  readonly keepsOrder: boolean
  /** Friction keeps one direction through a step, and static friction decides whether a block with v = 0 stays. */
  readonly holdsSlip: boolean
  /** Takes a step of `motion.dt`, or a shorter one whose length it leaves in `motion.dt`. */
  step(motion: Motion, integrator: Integrator): void
}
