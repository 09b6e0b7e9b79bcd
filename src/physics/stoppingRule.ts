import type { Described } from './options.ts'
import type { Integrator } from './integrator.ts'
import type { Motion } from './motion.ts'

/** What happens where the law jumps: where the block stops or turns, and at the joints of the track. */
export interface StoppingRule extends Described {
  /** Keeps the order of every integrator through stops and joints. */
  readonly keepsOrder: boolean
  /** Friction keeps one direction through a step. */
  readonly holdsSlip: boolean
  /** Moves the motion on by `motion.dt`, in one step of the integrator or, around a jump, in several. */
  advance(motion: Motion, integrator: Integrator): void
}
