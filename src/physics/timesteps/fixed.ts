import { ExactSum } from '../exactSum.ts'
import type { ChoiceOption, NumberOption, Values } from '../options.ts'
import { wholeSteps } from '../timestepPolicy.ts'
import type { TimestepPolicy } from '../timestepPolicy.ts'
import { cap as anyCap, maxSteps, step } from './options.ts'

const cap = {
  ...anyCap,
  // As good as none: only a game that hands in a longer frame would meet it, and there it does not hold.
  initial: anyCap.max,
  atMax: 'no limit',
  optional: true,
} as const satisfies NumberOption

const draw = {
  type: 'choice',
  label: 'Draw',
  choices: ['latest', 'interpolated', 'extrapolated'],
  initial: 'interpolated',
  optional: true,
} as const satisfies ChoiceOption

const options = { step, maxSteps, cap, draw } as const

/** Steps of one length; an accumulator carries what is left of a frame over to the next (Fiedler, 2004). */
export const fixed = {
  id: 'fixed',
  label: 'Fixed',
  about: 'Steps of one length whatever the frames do; the picture is drawn between two of them.',
  options,
  losesTime: false,
  steps: ({ step, maxSteps, cap }: Values<typeof options>, duration: number, frames: number) =>
    Math.min(Math.min(duration, longest(cap) * frames) / step, maxSteps * frames),
  start: ({ step, maxSteps, cap, draw }: Values<typeof options>) => {
    const longestFrame = longest(cap)
    // #region advance
    let taken = 0
    let dropped = 0
    // What frames exceed the cap by.
    const excess = new ExactSum()
    // A field, since engines box a number that a closure keeps changing.
    const before = { s: NaN }
    return (frame) => {
      const { motion } = frame
      if (frame.frameDuration > longestFrame) excess.add(frame.frameDuration - longestFrame)
      const time = frame.gameTime - excess.value
      // The accumulator is the time by which the wall clock is ahead of the physics: counted, not added up.
      const due = wholeSteps(time, step) - dropped - taken
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
      frame.lostTime = dropped * step + excess.value
      const accumulator = Math.max(0, time - (taken + dropped) * step)
      if (draw === 'extrapolated') frame.drawnS = motion.s + motion.v * accumulator
      if (draw === 'interpolated' && taken > 0)
        frame.drawnS = before.s + (motion.s - before.s) * (accumulator / step)
    }
    // #endregion
  },
} as const satisfies TimestepPolicy

/** The longest frame that is not cut [s]. */
function longest(cap: number): number {
  return cap < anyCap.max ? cap : Number.MAX_VALUE
}
