import type { NumberOption, Values } from '../options.ts'
import type { FrameContext, TimestepPolicy } from '../timestepPolicy.ts'

const tolerance = {
  type: 'number',
  label: 'Tolerance',
  symbol: 'ε',
  unit: 'm/s',
  min: 1e-12,
  max: 1e-3,
  slider: { from: 1e-12, to: 1e-3, step: 1e-12 },
  initial: 1e-6,
} as const satisfies NumberOption

const options = { tolerance } as const

// Usual choices (Hairer, Nørsett & Wanner, Solving Ordinary Differential Equations I, section II.4): aim a little below
// what is allowed, and don't believe a single estimate too much.
const SAFETY = 0.9
const SHORTER = 0.2
const LONGER = 5
// What rounding may leave between two ways to the same place, in parts of the size of what is compared.
const ROUNDING = 16 * Number.EPSILON
// A step that ends at an event ends there but for its error, so that the next may begin with the same event. So early in
// a step, in parts of it, an event hides less than a billionth of the error.
const EARLY = 1e-3
// Far more than any smooth motion asks for: the rule does not come to an end there.
const MOST_TRIES_A_FRAME = 1e6

/** As many steps as the error asks for: each is compared with two of half its length. */
export const toTolerance = {
  id: 'tolerance',
  label: 'To tolerance',
  about:
    'As many steps in each frame as the error that you allow asks for: small where the motion is quick, long where it is not.',
  options,
  losesTime: false,
  steps: (_: Values<typeof options>, __: number, frames: number) => 2 * frames,
  start: ({ tolerance }: Values<typeof options>) => {
    // The step that the last one recommends, and whether that one ended at an event. An object, since engines box a
    // number that a closure keeps changing.
    const next = { step: Infinity, afterEvent: false }
    return (frame) => {
      // #region advance
      const { motion, time, frameDuration } = frame
      let left = frameDuration
      for (let tries = 0; left > 0 && motion.moving; tries++) {
        if (tries === MOST_TRIES_A_FRAME) return frame.abandon()
        let step = left / Math.max(1, Math.ceil(left / next.step))
        frame.stateTime = time - left
        const atEvent = tryStep(frame, step, next.afterEvent ? EARLY : 0)
        step = 2 * motion.dt
        frame.allowed = tolerance * step
        const accepted = frame.error <= frame.allowed
        const factor = Math.max(SAFETY * root(frame.allowed / frame.error, frame.order), SHORTER)
        const recommended = step * Math.min(factor, LONGER)
        // A step that the end of the frame cut short says nothing against a longer one.
        next.step = accepted && factor >= 1 ? Math.max(recommended, next.step) : recommended
        if (accepted) {
          left = step === left ? 0 : left - step
          next.afterEvent = atEvent
        } else frame.restore()
        frame.judge(accepted)
      }
      frame.stateTime = time
      // #endregion
    }
  },
} as const satisfies TimestepPolicy

/**
 * Takes a step, takes it back, and takes it again in two halves, whose length it leaves in `motion.dt`. A step in which
 * something happens, later than that part of it, is cut to end there, since what comes before the event, or after it, is one
 * and the same step on both ways. Returns whether it was. Sets `error` to
 * how far off the halves are, by how far they are from the whole (Richardson, 1911): in place, and in a second's way
 * at the speed [m].
 */
function tryStep(frame: FrameContext, step: number, early: number): boolean {
  const { motion } = frame
  frame.save()
  motion.dt = step
  frame.step()
  const { firstPart } = motion
  const atEvent = firstPart > early * step && firstPart < step
  if (atEvent) {
    frame.restore()
    motion.dt = firstPart
    frame.step()
  }
  const { s, v, dt } = motion
  frame.restore()
  motion.dt = 0.5 * dt
  frame.step()
  frame.step(1, 1)
  const place = beyondRounding(motion.s, s)
  const speed = beyondRounding(motion.v, v)
  frame.error = (place + speed) / (power(2, frame.order) - 1)
  return atEvent
}

function beyondRounding(a: number, b: number): number {
  const difference = Math.abs(a - b)
  return difference <= ROUNDING * (Math.abs(a) + Math.abs(b)) ? 0 : difference
}

/** xⁿ. `Math.pow` differs from engine to engine. */
function power(x: number, n: number): number {
  let result = x
  for (let i = 1; i < n; i++) result *= x
  return result
}

/** The n-th root of x, as far as a step may change: by Newton's method, from above. Beyond that, any number beyond. */
function root(x: number, n: number): number {
  let y = 2 * LONGER
  while (y > SHORTER) {
    const next = y - (y - (x / power(y, n)) * y) / n
    if (!(next < y)) break
    y = next
  }
  return y
}
