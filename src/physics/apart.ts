import type { Motion } from './motion.ts'

/**
 * Calls a function that an engine is not to compile into its caller. The one call in here has met several functions, and such
 * a call is left a call. So all that V8 is willing to compile into one place (920 bytes of bytecode) goes to an integrator's own
 * loop, where a number that is passed to a function would be boxed if it was left out.
 */
export function apart<T = Motion>(part: (subject: T) => void, subject: T): void {
  part(subject)
}

// An engine notes what a call meets only once it has been made some times; a run may be of one function from there on.
const met = { odd: 0, even: 0 }
for (let i = 0; i < 1000; i++) apart(i % 2 === 1 ? countOdd : countEven, met)

function countOdd(counts: typeof met): void {
  counts.odd++
}

function countEven(counts: typeof met): void {
  counts.even++
}
