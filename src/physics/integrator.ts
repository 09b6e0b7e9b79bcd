import type { Described } from './options.ts'
import type { Motion } from './motion.ts'

/** An integrator: its step, and its claims. Every claim is tested. */
export interface Integrator extends Described {
  /** The step as formulas, one per line. */
  readonly formula: readonly string[]
  /** The power of dt with which the error falls in smooth motion. */
  readonly order: number
  /** The order where the force depends on v. */
  readonly orderWithSpeed: number
  /** Steps of dt on an oscillation of angular frequency ω stay bounded for ω dt below this; 0: never. */
  readonly stability: number
  /** It preserves phase-space area, so that at a fixed step its energy error stays bounded. */
  readonly symplectic: boolean
  /** Evaluations of the acceleration in a step: the fewest (by reuse, where the force ignores v) and the most. */
  readonly evaluations: { readonly least: number; readonly most: number }
  /** Place in the palette, 0 … 7. */
  readonly colour: number
  /** Advances `motion.s` and `motion.v` by `motion.dt`. */
  step(motion: Motion): void
}
