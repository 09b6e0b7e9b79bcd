import type { ChoiceOption, NumberOption, Values } from '../options.ts'
import { MOST_STEPS_A_FRAME, wholeSteps } from '../timestepPolicy.ts'
import type { TimestepPolicy } from '../timestepPolicy.ts'
import { step } from './options.ts'

const maxSteps = {
  type: 'number',
  label: 'Most steps a frame',
  symbol: 'n',
  unit: '',
  min: 1,
  max: MOST_STEPS_A_FRAME,
  atMax: 'no limit',
  integer: true,
  slider: { from: 1, to: 60, step: 1 },
  initial: MOST_STEPS_A_FRAME,
  optional: true,
} as const satisfies NumberOption

const draw = {
  type: 'choice',
  label: 'Draw',
  choices: ['latest', 'interpolated', 'extrapolated'],
  initial: 'interpolated',
  optional: true,
} as const satisfies ChoiceOption

const options = { step, maxSteps, draw } as const

/** Steps of one length; an accumulator carries what is left of a frame over to the next (Fiedler, 2004). */
export const fixed = {
  id: 'fixed',
  label: 'Fixed',
  about:
    'Physics takes steps of one length whatever the frames do, and the picture is drawn between two of them.',
  options,
  losesTime: false,
  steps: ({ step, maxSteps }: Values<typeof options>, duration: number, frames: number) =>
    Math.min(duration / step, maxSteps * frames),
  start: ({ step, maxSteps, draw }: Values<typeof options>) => {
    // #region advance
    let taken = 0
    let dropped = 0
    // A field, since engines box a number that a closure keeps changing.
    const before = { s: NaN }
    return (frame) => {
      const { motion } = frame
      // The accumulator is the time by which the wall clock is ahead of the physics: counted, not added up.
      const due = wholeSteps(frame.time, step) - dropped - taken
      const count = Math.min(due, maxSteps)
      dropped += due - count
      if (count > 0) {
        motion.dt = step
        frame.stateTime = 0
        frame.step(count - 1, taken)
        before.s = motion.s
        frame.step(1, taken + count - 1)
        taken += count
        frame.stateTime = taken * step
      }
      frame.lostTime = dropped * step
      const accumulator = Math.max(0, frame.time - (taken + dropped) * step)
      if (draw === 'extrapolated') frame.drawnS = motion.s + motion.v * accumulator
      if (draw === 'interpolated' && taken > 0)
        frame.drawnS = before.s + (motion.s - before.s) * (accumulator / step)
    }
    // #endregion
  },
} as const satisfies TimestepPolicy
