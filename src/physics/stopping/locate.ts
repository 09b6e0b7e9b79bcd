import type { Integrator } from '../integrator.ts'
import type { Motion } from '../motion.ts'

/** What is looked for: the instant of v = 0, or that of reaching the end or the beginning of the piece of track. */
export type Jump = 'turn' | 'to' | 'from'

const MOST_ITERATIONS = 100

/**
 * Shortens a step that went past a jump so that it ends there: finds the length between 0 and `motion.dt` for which
 * the integrator's own step, from where it began, ends at the jump to rounding. Leaves the length in `motion.dt` and
 * the motion at that step's end.
 *
 * Regula falsi in the form of Anderson and Björck (1973), which keeps the root bracketed, with a bisection now and then
 * so that the bracket is sure to close.
 */
export function locate(motion: Motion, integrator: Integrator, jump: Jump): void {
  let late = motion.dt
  let missLate = distanceTo(motion, jump)
  let early = 0
  motion.rewind()
  let missEarly = distanceTo(motion, jump)
  const scale = jump === 'turn' ? Math.abs(motion.v) : Math.abs(motion[jump])
  const small = Number.EPSILON * Math.max(scale, Math.abs(missLate), Math.abs(missEarly))
  if (missEarly <= 0) {
    // The step begins at the very jump that it comes back to: look for a length before that.
    for (early = late / 2; early > 0; early /= 2) {
      missEarly = retry(motion, integrator, early, jump)
      if (missEarly > 0) break
      late = early
      missLate = missEarly
    }
    if (early === 0) return
  }
  let lastSide = 0
  for (let i = 1; i <= MOST_ITERATIONS; i++) {
    let length = early + ((late - early) * missEarly) / (missEarly - missLate)
    if (i % 8 === 0 || !(length > early && length < late)) length = early + 0.5 * (late - early)
    const miss = retry(motion, integrator, length, jump)
    if (Math.abs(miss) <= small || late - early <= Number.EPSILON * late) return
    // An end that has stayed where it is while the other moved twice is given less weight, so that it moves next.
    if (miss > 0) {
      if (lastSide > 0) missLate *= lessWeight(miss, missEarly)
      early = length
      missEarly = miss
      lastSide = 1
    } else {
      if (lastSide < 0) missEarly *= lessWeight(miss, missLate)
      late = length
      missLate = miss
      lastSide = -1
    }
  }
}

function lessWeight(miss: number, before: number): number {
  const factor = 1 - miss / before
  return factor > 0 ? factor : 0.5
}

/** Takes the step again with another length; returns how far before the jump it ends. */
function retry(motion: Motion, integrator: Integrator, length: number, jump: Jump): number {
  motion.rewind()
  motion.dt = length
  integrator.step(motion)
  return distanceTo(motion, jump)
}

/** How far before the jump the motion is: positive before, negative past it. */
function distanceTo(motion: Motion, jump: Jump): number {
  if (jump === 'turn') return motion.slip * motion.v
  return jump === 'to' ? motion.to - motion.s : motion.s - motion.from
}
