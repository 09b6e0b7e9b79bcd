import type { Described } from './options.ts'
import type { Motion } from './motion.ts'

/** A way to take one step, and what it claims. Every claim is tested. */
export interface Integrator extends Described {
  /** The step in the letters of the field, a line each. */
  readonly formula: readonly string[]
  /** The power of dt with which the error falls in smooth motion. */
  readonly order: number
  /** The same where the force depends on v. */
  readonly orderWithSpeed: number
  /** On an oscillation of angular frequency ω a step dt stays bounded for ω dt below this; 0: never. */
  readonly stability: number
  /** It preserves phase-space area, so that at a fixed step its energy error stays bounded. */
  readonly symplectic: boolean
  /** Evaluations of the acceleration in a step: the fewest (by reuse, where the force ignores v) and the most. */
  readonly evaluations: { readonly least: number; readonly most: number }
  /** Place in the palette, 0 … 7. */
  readonly colour: number
  /** Moves `motion.s` and `motion.v` on by `motion.dt`, from one evaluation of the acceleration to the next. */
  step(motion: Motion): void
}
