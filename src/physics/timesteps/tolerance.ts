import type { NumberOption, Values } from '../options.ts'
import type { FrameContext, TimestepPolicy } from '../timestepPolicy.ts'

const tolerance = {
  type: 'number',
  label: 'Tolerance',
  symbol: 'ε',
  unit: 'm/s',
  min: 1e-12,
  max: 1e-3,
  slider: { from: 1e-12, to: 1e-3, step: 1 / 3, scale: 'logarithmic' },
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
// Where rounding hides the error, each long step is refused after each short one. So a step that was refused is
// followed by one as long as it recommends, and the next ones are longer by this factor only, by its square and so on.
const TRUST = 1.5
// Evaluations, far more than a smooth motion asks for: in each frame, and for each second of it up to one. A rule that
// trembles, as naive friction does at rest, does not come to an end.
const MOST = 1e6
const MORE = 1e7

/** As many steps as the error asks for: each is compared with two of half its length. */
export const toTolerance = {
  id: 'tolerance',
  label: 'To tolerance',
  about: 'As many steps a frame as the tolerance asks for: short where the motion is quick.',
  options,
  losesTime: false,
  steps: (_: Values<typeof options>, __: number, frames: number) => 2 * frames,
  start: ({ tolerance }: Values<typeof options>) => {
    const next: Next = {
      ...{ tolerance, left: NaN, step: Infinity, factor: NaN, longer: LONGER },
    }
    return (frame) => {
      next.left = frame.frameDuration
      const { motion } = frame
      const most = motion.evaluations + MOST + MORE * Math.min(1, next.left)
      while (next.left > 0 && motion.moving) {
        if (motion.evaluations > most || next.left / next.step === Infinity) return frame.abandon()
        advance(frame, next)
      }
      frame.stateTime = frame.gameTime
    }
  },
} as const satisfies TimestepPolicy

/** Tries a step of the frame, keeps it or takes it back, and decides how long the next is. */
function advance(frame: FrameContext, next: Next): void {
  // #region advance
  const { motion } = frame
  frame.stateTime = frame.gameTime - next.left
  const asked = next.left / Math.max(1, Math.ceil(next.left / next.step))
  motion.dt = asked
  tryStep(frame)
  const step = frame.tried
  frame.allowed = next.tolerance * step
  const accepted = frame.error <= frame.allowed
  adapt(next, frame)
  // A step that the end of the frame cut short says nothing against a longer one.
  const keeps = accepted && next.factor >= 1 && next.step > step * next.factor
  if (!keeps) next.step = step * next.factor
  if (accepted) {
    if (step < asked) {
      frame.restore()
      motion.dt = asked
      frame.stepToEvent()
    }
    next.left = step === next.left ? 0 : next.left - step
    next.longer = Math.min(TRUST * next.longer, LONGER)
  } else {
    next.longer = 1
    frame.restore()
  }
  frame.judge(accepted)
  // #endregion
}

/** What one try hands on to the next. Numbers stand in fields, since engines box one that is passed or returned. */
interface Next {
  /** [m/s] */
  readonly tolerance: number
  /** What is left of the frame [s]. */
  left: number
  /** The length that the last step recommends [s], and by which factor it was longer or shorter. */
  step: number
  factor: number
  /** The largest factor that is believed. */
  longer: number
}

/**
 * Takes a step of `motion.dt`, or up to where the stopping rule ends it: so the whole is a single step, and has no part in
 * common with the two halves, in which it is then taken again. Leaves its length in `tried`, and in `error` how far off
 * the halves are, by how far they are from the whole (Richardson, 1911): in place, and in a second's way at the speed [m].
 * A whole that was ended early is what will be kept, since it ends at the event exactly and the halves just before or
 * after it: then `error` is of the whole.
 */
function tryStep(frame: FrameContext): void {
  const { motion, order } = frame
  const asked = motion.dt
  frame.save()
  frame.stepToEvent()
  const { s, v, dt } = motion
  frame.restore()
  motion.dt = 0.5 * dt
  frame.step()
  frame.step(1, 1)
  const place = Math.abs(motion.s - s)
  const speed = Math.abs(motion.v - v)
  let error = place <= ROUNDING * (Math.abs(s) + Math.abs(motion.s)) ? 0 : place
  if (speed > ROUNDING * (Math.abs(v) + Math.abs(motion.v))) error += speed
  // The whole is off by 2ᵖ of what the halves are.
  let ratio = 1
  for (let i = 0; i < order; i++) ratio *= 2
  frame.tried = dt
  frame.error = error / (ratio - 1)
  if (dt < asked) frame.error *= ratio
}

/**
 * Sets the factor for the next step: the p-th root of what is allowed in parts of the error, since the error in a second
 * falls with the p-th power of the step. By Newton's method from above, down to the smallest factor that matters:
 * `Math.pow` differs from engine to engine.
 */
function adapt(next: Next, { allowed, error, order }: FrameContext): void {
  const x = allowed / error
  let y = 2 * LONGER
  while (y > SHORTER) {
    let power = 1
    for (let i = 1; i < order; i++) power *= y
    const root = y - (y - x / power) / order
    if (!(root < y)) break
    y = root
  }
  next.factor = Math.min(Math.max(SAFETY * y, SHORTER), next.longer)
}
