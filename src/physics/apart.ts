import type { Motion } from './motion.ts'

/**
 * Calls a function that an engine is not to compile into its caller. The one call in here meets several functions in every
 * run, and what has met several is left a call. So all that V8 is willing to compile into one place (920 bytes of
 * bytecode) goes to an integrator's own loop, where a number that is passed to a function would be boxed if it was left out.
 */
export function apart(part: (motion: Motion) => void, motion: Motion): void {
  part(motion)
}
