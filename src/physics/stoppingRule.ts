import type { Integrator } from './integrator.ts'
import type { Described } from './options.ts'
import type { Motion } from './motion.ts'

/** What happens where the law jumps: where the block stops or turns, and at the joints of the track. */
export interface StoppingRule extends Described {
  /** Keeps the order of every integrator through stops and joints. */
  readonly keepsOrder: boolean
  /** Friction keeps one direction through a step, and a block with v = 0 is asked whether it stays. */
  readonly holdsSlip: boolean
  /** Takes a step of `motion.dt`, or of less, which it then leaves in `motion.dt`. */
  step(motion: Motion, integrator: Integrator): void
}
