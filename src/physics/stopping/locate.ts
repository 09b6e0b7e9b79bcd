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
  aim(motion, jump)
  let late = motion.dt
  let missLate = motion.miss
  motion.rewind()
  aim(motion, jump)
  let early = 0
  let missEarly = motion.miss
  const scale = jump === 'turn' ? Math.abs(motion.v) : Math.abs(motion[jump])
  const small = Number.EPSILON * Math.max(scale, Math.abs(missLate), Math.abs(missEarly))
  if (missEarly <= 0) {
    // The step begins at the very jump that it comes back to: look for a length before that.
    for (early = late / 2; early > 0; early /= 2) {
      motion.dt = early
      retry(motion, integrator, jump)
      missEarly = motion.miss
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
    motion.dt = length
    retry(motion, integrator, jump)
    const { miss } = motion
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

/** Takes the step again, now of `motion.dt`. */
function retry(motion: Motion, integrator: Integrator, jump: Jump): void {
  motion.rewind()
  integrator.step(motion)
  aim(motion, jump)
}

/** Sets `miss` to how far before the jump the motion is. */
function aim(motion: Motion, jump: Jump): void {
  motion.miss =
    jump === 'turn'
      ? motion.slip * motion.v
      : jump === 'to'
        ? motion.to - motion.s
        : motion.s - motion.from
}
